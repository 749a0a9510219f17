package org.jsmesh.upload;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whose models are whose, and who may send more. */
class KeepingTest {
    private static final String ME = "a".repeat(64);
    private static final String OTHER = "b".repeat(64);

    @TempDir
    private Path folder;

    private Path record;
    private Keeping keeping;

    @BeforeEach
    void open() throws IOException {
        record = folder.resolve(".senders");
        keeping = Keeping.open(record, id -> folder.resolve(id));
    }

    private static Sender models(int most) {
        return new Sender(ME, Long.MAX_VALUE, most);
    }

    private static Sender bytes(long most) {
        return new Sender(ME, most, Integer.MAX_VALUE);
    }

    private void keep(String key, String id, int bytes) throws IOException {
        keeping.note(key, id);
        Files.write(folder.resolve(id), new byte[bytes]);
    }

    @Test
    void shouldCountModelsThatAreKeptAndThatCome() throws IOException {
        keep(ME, "a", 1);
        keep(OTHER, "x", 1);
        assertThat(keeping.refusal(models(2), "b")).isNull();
        assertThat(keeping.refusal(models(2), "b")).as("the same again").isNull();
        assertThat(keeping.refusal(models(2), "c")).contains("2 models");
        keeping.gone(ME, "b");
        assertThat(keeping.refusal(models(2), "c")).contains("2 models");
        keeping.gone(ME, "b");
        assertThat(keeping.refusal(models(2), "c")).isNull();
        keeping.gone(ME, "c");
        assertThat(keeping.refusal(models(1), "a")).isNull();
        assertThat(keeping.refusal(models(0), "a")).contains("0 models");
    }

    @Test
    void shouldCountBytesOfArchivesThatAreThere() throws IOException {
        keep(ME, "a", 600);
        assertThat(keeping.refusal(bytes(1000), "b", 400)).isNull();
        assertThat(keeping.refusal(bytes(1000), "b", 401)).contains("1000 bytes", "would be 1001");
        assertThat(keeping.refusal(bytes(1000), "a", 1000)).as("replaced").isNull();
        assertThat(keeping.refusal(bytes(600), "b")).contains("full");
        // Whoever removes an archive makes room.
        Files.delete(folder.resolve("a"));
        assertThat(keeping.refusal(bytes(600), "b")).isNull();
        assertThat(keeping.refusal(bytes(1000), "b", 1000)).isNull();
    }

    @Test
    void shouldRememberAfterACutLine() throws IOException {
        keep(ME, "a", 600);
        keep(ME, "b", 1);
        keep(OTHER, "b", 1);
        keep(ME, "gone", 1);
        Files.delete(folder.resolve("gone"));
        Files.writeString(record, "c " + "a".repeat(20), StandardOpenOption.APPEND);
        open();
        assertThat(record).hasContent("a " + ME + "\nb " + OTHER + "\n");
        assertThat(keeping.refusal(bytes(600), "z")).contains("full");
        Files.writeString(record, "c " + "a".repeat(20), StandardOpenOption.APPEND);
        keep(ME, "d", 1);
        open();
        assertThat(record).hasContent("a " + ME + "\nb " + OTHER + "\nd " + ME + "\n");
    }
}
