package org.jsmesh.objects;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class FolderVersionsTest {
    @TempDir
    private Path folder;

    @Test
    void shouldKnowAVersionByWhatIsTheSameOnAllMachines() {
        assertThat(FolderObjectStore.number("(dev=fe01,ino=123)")).isEqualTo("123");
        assertThat(FolderObjectStore.number("(dev=2b,ino=123)")).isEqualTo("123");
        assertThat(FolderObjectStore.number(null)).isEmpty();
    }

    @Test
    @EnabledOnOs({OS.LINUX, OS.MAC})
    void shouldTellFilesOfOneTimeAndLengthApart() throws Exception {
        try (FolderObjectStore store = new FolderObjectStore(folder)) {
            StoredObject first = store.put(Upload.of("a", ObjectContent.of(new byte[1])));
            Files.copy(folder.resolve("a"), folder.resolve("b"));
            Files.setLastModifiedTime(folder.resolve("b"), Files.getLastModifiedTime(folder.resolve("a")));
            assertThat(store.find("b").orElseThrow().tag()).isNotEqualTo(first.tag());
        }
    }

    @Test
    void shouldReadAVersionByItsTagAlone() throws Exception {
        try (FolderObjectStore store = new FolderObjectStore(folder)) {
            StoredObject there = store.put(Upload.of("a", ObjectContent.of("text".getBytes(UTF_8))));
            ByteBuffer into = ByteBuffer.allocate(4);
            store.read(new StoredObject("a", 4, there.tag(), Instant.EPOCH), 0, into);
            assertThat(new String(into.array(), UTF_8)).isEqualTo("text");
            StoredObject other = new StoredObject("a", 4, "other", there.modified());
            assertThatThrownBy(() -> store.read(other, 0, ByteBuffer.allocate(4)))
                    .isInstanceOf(ObjectConflictException.class);
        }
    }

    @Test
    void shouldReplaceOnlyVersionsThatCanBeTold() {
        assertThatThrownBy(() -> Condition.replacing(new StoredObject("k", 1, null, Instant.EPOCH)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("k has no tag");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void shouldTellOfNamesThatTheLocaleCannotHold() throws Exception {
        // By an address, because the locale of the tests need not hold the name either.
        Files.createDirectory(folder.resolve("in"));
        Files.writeString(Path.of(URI.create(folder.toUri() + "in/%E6%A8%A1.off")), "");
        Files.createDirectory(folder.resolve("other"));
        assertThat(list("in/")).contains("in/%E6%A8%A1.off", "the locale of this process", "LC_ALL=C.UTF-8");
        assertThat(list("other/")).isEqualTo("listed");
    }

    private String list(String prefix) throws IOException, InterruptedException {
        ProcessBuilder java = new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx32m",
                "-cp",
                System.getProperty("java.class.path"),
                Listing.class.getName(),
                folder.toString(),
                prefix);
        java.environment().put("LC_ALL", "C");
        Process process = java.redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), UTF_8);
        process.waitFor();
        return said.strip();
    }

    /** In a process of its own. */
    public static final class Listing {
        private Listing() {}

        public static void main(String[] arguments) {
            try (FolderObjectStore store = new FolderObjectStore(Path.of(arguments[0]))) {
                store.list(arguments[1], "", object -> true);
                System.out.println("listed");
            } catch (IOException e) {
                System.out.println(e.getMessage());
            }
        }
    }
}
