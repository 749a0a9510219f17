package org.jsmesh.secret;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Secrets that change while the server runs. */
class SecretFileTest {
    private static final long SECOND = 1_000_000_000L;

    @TempDir
    private Path folder;

    private final AtomicLong nanos = new AtomicLong();

    private SecretFile<List<String>> open(Path file) throws IOException {
        return SecretFile.open(
                file,
                lines -> {
                    if (lines.contains("bad")) throw new IllegalArgumentException("a line is bad");
                    return lines;
                },
                nanos::get);
    }

    /** As old as files are that nobody is writing. */
    private static void write(Path file, String text) throws IOException {
        Files.writeString(file, text);
        Files.setLastModifiedTime(file, FileTime.fromMillis(System.currentTimeMillis() - 60_000));
    }

    @Test
    void shouldSeeANewContentAfterASecond() throws IOException {
        Path file = folder.resolve("secrets");
        write(file, "# who\n\n one \n");
        SecretFile<List<String>> secrets = open(file);
        assertThat(secrets.get()).containsExactly("one");
        write(file, "one\ntwo\n");
        nanos.addAndGet(SECOND - 1);
        assertThat(secrets.get()).containsExactly("one");
        nanos.addAndGet(1);
        assertThat(secrets.get()).containsExactly("one", "two");
        // Moved into place, as careful editors do, with the size and the time of the old one.
        FileTime time = Files.getLastModifiedTime(file);
        Path other = Files.writeString(folder.resolve("other"), "one\nTWO\n");
        Files.setLastModifiedTime(other, time);
        Files.move(other, file, StandardCopyOption.REPLACE_EXISTING);
        nanos.addAndGet(SECOND);
        assertThat(secrets.get()).containsExactly("one", "TWO");
    }

    @Test
    void shouldSeeTwoChangesOfOneMoment() throws IOException {
        Path file = Files.writeString(folder.resolve("secrets"), "one");
        FileTime time = Files.getLastModifiedTime(file);
        SecretFile<List<String>> secrets = open(file);
        Files.writeString(file, "two");
        Files.setLastModifiedTime(file, time);
        nanos.addAndGet(SECOND);
        assertThat(secrets.get()).containsExactly("two");
    }

    @Test
    void shouldKeepWhatWasGoodAndSaySoOnce() throws IOException {
        Path file = folder.resolve("secrets");
        write(file, "one");
        SecretFile<List<String>> secrets = open(file);
        List<LogRecord> told = new ArrayList<>();
        Handler handler = new Handler() {
            @Override
            public void publish(LogRecord message) {
                told.add(message);
            }

            @Override
            public void flush() {}

            @Override
            public void close() {}
        };
        Logger log = Logger.getLogger(SecretFile.class.getName());
        log.addHandler(handler);
        try {
            Files.writeString(file, "secret\nbad");
            for (int i = 0; i < 5; i++) {
                nanos.addAndGet(SECOND);
                assertThat(secrets.get()).containsExactly("one");
            }
            assertThat(told).hasSize(1);
            Files.delete(file);
            for (int i = 0; i < 5; i++) {
                nanos.addAndGet(SECOND);
                assertThat(secrets.get()).containsExactly("one");
            }
            assertThat(told).hasSize(2);
            write(file, "three");
            nanos.addAndGet(SECOND);
            assertThat(secrets.get()).containsExactly("three");
            assertThat(told).hasSize(2);
        } finally {
            log.removeHandler(handler);
        }
        assertThat(String.valueOf(told.get(0).getParameters()[0]))
                .contains("secrets", "a line is bad")
                .doesNotContain("secret\n");
        assertThat(String.valueOf(told.get(1).getParameters()[0])).contains("secrets is gone");
    }

    @Test
    void shouldRefuseAFileThatIsWrongFromTheBeginning() throws IOException {
        Path bad = Files.writeString(folder.resolve("secrets"), "bad");
        assertThatThrownBy(() -> open(bad))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining("a line is bad");
        Path binary = Files.write(folder.resolve("binary"), new byte[] {(byte) 0xff, (byte) 0xfe, 0});
        assertThatThrownBy(() -> open(binary))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining("UTF-8");
    }
}
