package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.jsmesh.servlet.testing.SignedJars;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ViewerOptionTest {
    @TempDir
    private Path folder;

    @Test
    void shouldTakeTheSignedViewerBesideTheProgram() throws Exception {
        Path program = Files.createFile(folder.resolve("jsm.jar"));
        assertThat(ViewerOption.beside(program)).isNull();
        assertThat(ViewerOption.beside(null)).isNull();
        Path viewer = folder.resolve("jsm-viewer.jar");
        SignedJars.unsigned(viewer, Map.of("Main-Class", "org.example.Main"), 10);
        assertThat(ViewerOption.beside(program)).isNull();
        SignedJars.viewer(viewer, 10);
        assertThat(ViewerOption.beside(program)).isNotNull();
    }

    @Test
    void shouldRefuseAViewerThatNobodyCanStart() throws Exception {
        Path plain = SignedJars.unsigned(folder.resolve("plain.jar"), Map.of("Main-Class", "org.example.Main"), 10);
        Cli result = Cli.run("serve", folder.toString(), "--viewer-jar", plain.toString());
        assertThat(result.code()).isEqualTo(1);
        assertThat(result.err()).contains("plain.jar", "the desktop viewer cannot be started from there");
    }
}
