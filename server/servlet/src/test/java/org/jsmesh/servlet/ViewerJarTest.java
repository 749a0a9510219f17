package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Map;
import org.jsmesh.servlet.http.ResponseSender;
import org.jsmesh.servlet.testing.SignedJars;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ViewerJarTest {
    private static final Map<String, String> GOOD =
            Map.of("Main-Class", "org.example.Main", "Permissions", "all-permissions");

    @TempDir
    private Path folder;

    @Test
    void shouldTakeASignedJar() throws Exception {
        ViewerJar.State state = ViewerJar.open(SignedJars.viewer(folder.resolve("viewer.jar"), 10))
                .state();
        assertThat(state.mainClass()).isEqualTo("org.example.Main");
        assertThat(state.bytes()).isEqualTo(Files.size(folder.resolve("viewer.jar")));
    }

    @Test
    void shouldRefuseWhatCannotBeStarted() throws Exception {
        assertRefused(folder.resolve("none.jar"), "there is no such file");
        assertRefused(Files.writeString(folder.resolve("text.jar"), "no jar at all"), "it is no jar");
        assertRefused(
                SignedJars.unsigned(folder.resolve("plain.jar"), GOOD, 10),
                "not all of it is signed; sign it with jarsigner");
        assertRefused(
                SignedJars.unsigned(folder.resolve("nothing.jar"), Map.of(), 10), "its manifest names no Main-Class");
        Map<String, String> elsewhere = Map.of("Main-Class", "org.example.Other", "Permissions", "all-permissions");
        assertRefused(
                SignedJars.unsigned(folder.resolve("other.jar"), elsewhere, 10),
                "it lacks its main class org.example.Other");
        Path modest = SignedJars.unsigned(folder.resolve("modest.jar"), Map.of("Main-Class", "org.example.Main"), 10);
        assertRefused(
                SignedJars.signed(modest, folder.resolve("modest-signed.jar")),
                "its manifest does not say 'Permissions: all-permissions'");
    }

    @Test
    void shouldRefuseAJarThatWasChangedAfterwards() throws Exception {
        Path changed = SignedJars.viewer(folder.resolve("changed.jar"), 10);
        try (FileSystem jar = FileSystems.newFileSystem(changed)) {
            Files.write(jar.getPath("org/example/Main.class"), new byte[] {9, 9, 9});
        }
        assertRefused(changed, "it has been changed since it was signed");
    }

    @Test
    void shouldRefuseAJarToWhichSomethingWasAddedAfterwards() throws Exception {
        Path changed = SignedJars.viewer(folder.resolve("added.jar"), 10);
        try (FileSystem jar = FileSystems.newFileSystem(changed)) {
            Files.write(jar.getPath("org/example/More.class"), new byte[] {9, 9, 9});
        }
        assertRefused(changed, "not all of it is signed");
    }

    @Test
    void shouldOfferAViewerThatComesBack() throws Exception {
        Path file = SignedJars.viewer(folder.resolve("viewer.jar"), 10);
        ViewerJar viewer = ViewerJar.open(file);
        String sha256 = viewer.state().sha256();
        Path away = Files.move(file, folder.resolve("away.jar"));
        assertThat(viewer.state()).isNull();
        assertThat(viewer.state()).isNull();
        Files.move(away, file);
        assertThat(viewer.state().sha256()).isEqualTo(sha256);
    }

    /** What an answer sends is what its address names. */
    @Test
    void shouldSendTheBytesThatWereHashedThoughAnotherFileHasTheirName() throws Exception {
        Path file = SignedJars.viewer(folder.resolve("viewer.jar"), 10);
        byte[] bytes = Files.readAllBytes(file);
        ViewerJar viewer = ViewerJar.open(file);
        ViewerJar.State old = viewer.state();
        ResponseSender.Source source = old.content().source();
        Files.move(SignedJars.viewer(folder.resolve("next.jar"), 9000), file, StandardCopyOption.REPLACE_EXISTING);
        assertThat(viewer.state().sha256()).isNotEqualTo(old.sha256());
        ByteBuffer sent = source.next(0, bytes.length);
        assertThat(sent).isEqualTo(ByteBuffer.wrap(bytes));
        assertThat(old.content().source()).as("for another answer").isNull();
        assertThat(old.content().channel().isOpen()).isTrue();
        source.ended(true);
        assertThat(old.content().channel().isOpen()).isFalse();
    }

    private static void assertRefused(Path file, String why) {
        assertThatThrownBy(() -> ViewerJar.open(file))
                .isInstanceOf(IOException.class)
                .hasMessageContaining(file.getFileName().toString())
                .hasMessageContaining(why);
    }
}
