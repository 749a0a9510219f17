package org.jsmesh.encoder;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class EncodePlanTest {
    @TempDir
    private Path folder;

    @Test
    void shouldTakeTheOutputAsAFileForOneInput() {
        Path out = folder.resolve("x.jsm");
        assertThat(EncodePlan.of(folder.resolve("bunny.ply"), out))
                .containsExactly(new EncodeJob(folder.resolve("bunny.ply"), out));
        assertThat(EncodePlan.of(folder.resolve("bunny.ply"), folder))
                .containsExactly(new EncodeJob(folder.resolve("bunny.ply"), folder.resolve("bunny.jsm")));
    }

    @Test
    void shouldTakeTheModelsOfAFolderAtAnyDepthInOneOrder() throws IOException {
        Path in = Files.createDirectory(folder.resolve("in"));
        Path deep = Files.createDirectories(in.resolve("deep/er"));
        touch(
                in.resolve("b.ply"),
                in.resolve("a.OBJ"),
                in.resolve("a.mtl"),
                in.resolve("README.md"),
                in.resolve(".c.stl"),
                deep.resolve("d.m"));
        Path out = folder.resolve("out");
        assertThat(EncodePlan.of(List.of(in), out))
                .containsExactly(
                        new EncodeJob(in.resolve("a.OBJ"), out.resolve("a.jsm")),
                        new EncodeJob(in.resolve("b.ply"), out.resolve("b.jsm")),
                        new EncodeJob(deep.resolve("d.m"), out.resolve("deep/er/d.jsm")));
    }

    @Test
    void shouldKeepTheExtensionWhereNamesWouldMeet() throws IOException {
        Path out = folder.resolve("out");
        List<Path> inputs = List.of(Path.of("x/a.ply"), Path.of("y/a.obj"), Path.of("b.stl"));
        assertThat(EncodePlan.of(inputs, out).stream().map(EncodeJob::output))
                .containsExactly(out.resolve("a.ply.jsm"), out.resolve("a.obj.jsm"), out.resolve("b.jsm"));
    }

    @Test
    void shouldRefuseTwoInputsForOnePlace() {
        assertThatThrownBy(() -> EncodePlan.of(List.of(Path.of("x/a.ply"), Path.of("y/a.ply")), folder))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("a.ply.jsm");
    }

    @Test
    void shouldSayWhenAFolderHoldsNoModel() {
        assertThatThrownBy(() -> EncodePlan.of(List.of(folder), folder.resolve("out")))
                .isInstanceOf(NoSuchFileException.class)
                .hasMessageContaining(folder.toString());
    }

    private static void touch(Path... files) throws IOException {
        for (Path file : files) Files.createFile(file);
    }
}
