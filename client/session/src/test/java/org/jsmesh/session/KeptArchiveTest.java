package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.stream.Stream;
import org.jsmesh.session.testing.ProxiedExchange;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What sessions keep on disk for later ones. */
class KeptArchiveTest extends SessionFixture {
    @TempDir
    private Path folder;

    private URI hashed(byte[] bytes) {
        return proxy.through(server.put("/m/x/" + FakeArchive.sha256(bytes) + ".jsm", bytes));
    }

    private SessionOptions keeping() {
        return QUICK.withCache(folder.resolve("cache"));
    }

    /** Receives at least this much, and ends without another word. */
    private long receive(URI address, SessionOptions options, long atLeast) throws Exception {
        proxy.bytesPerSecond(400_000);
        try (StreamingSession session = open(address, options)) {
            Await.until(atLeast + " bytes", () -> {
                session.refine(200).join();
                return session.progress().bytes() >= atLeast;
            });
        }
        proxy.bytesPerSecond(1e9);
        return sent();
    }

    private long sent() {
        return proxy.exchanges().stream().mapToLong(ProxiedExchange::bodyBytes).sum();
    }

    private void assertCompletes(URI address, SessionOptions options, long keptBytes) {
        int before = proxy.exchanges().size();
        try (StreamingSession session = open(address, options)) {
            assertThat(session.complete().join().identical()).isTrue();
            List<ProxiedExchange> later =
                    proxy.exchanges().subList(before, proxy.exchanges().size());
            assertThat(later.stream().mapToLong(ProxiedExchange::bodyBytes).sum())
                    .isEqualTo(archive.length - keptBytes);
            assertThat(later).allMatch(e -> e.fromByte() >= keptBytes);
        }
    }

    @Test
    void shouldAskForTheMissingBytesAlone() throws Exception {
        URI address = hashed(archive);
        receive(address, keeping(), 60_000);
        long kept = Files.size(only(".jsm"));
        assertThat(kept).isBetween(60_000L, archive.length - 1L);
        assertCompletes(address, keeping(), kept);
        assertThat(only(".jsm")).hasBinaryContent(archive);
    }

    @Test
    void shouldBringTheOriginalAgainWithoutAByteAndLearnNothingFromIt() {
        URI address = hashed(archive);
        assertCompletes(address, keeping(), 0);
        int before = proxy.exchanges().size();
        try (StreamingSession session = open(address, keeping())) {
            assertThat(session.complete().join().identical()).isTrue();
            assertThat(session.progress().bytesPerSecond()).isZero();
            assertThat(session.trace().requests()).isEmpty();
        }
        assertThat(proxy.exchanges()).hasSize(before);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, .3, .5, .99})
    void shouldDropDamagedBytesAndAllBehindThem(double place) throws Exception {
        URI address = hashed(archive);
        receive(address, keeping(), 100_000);
        Path data = only(".jsm");
        long damaged = (long) (place * Files.size(data));
        try (RandomAccessFile file = new RandomAccessFile(data.toFile(), "rw")) {
            file.seek(damaged);
            int b = file.read();
            file.seek(damaged);
            file.write(b ^ 1);
        }
        int before = proxy.exchanges().size();
        try (StreamingSession session = open(address, keeping())) {
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(proxy.exchanges().get(before).fromByte()).isLessThanOrEqualTo(damaged);
        assertThat(data).hasBinaryContent(archive);
    }

    @ParameterizedTest
    @ValueSource(strings = {".jsm", ".log"})
    void shouldLiveWithFilesThatAreCut(String end) throws Exception {
        URI address = hashed(archive);
        receive(address, keeping(), 100_000);
        Path file = only(end);
        try (RandomAccessFile cut = new RandomAccessFile(file.toFile(), "rw")) {
            cut.setLength(cut.length() - 5);
        }
        try (StreamingSession session = open(address, keeping())) {
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(only(".jsm")).hasBinaryContent(archive);
    }

    @Test
    void shouldBelieveNoOtherHost() throws Exception {
        receive(hashed(archive), keeping(), 60_000);
        URI direct =
                URI.create("http://localhost:" + proxy.port() + hashed(archive).getPath());
        int before = proxy.exchanges().size();
        try (StreamingSession session = open(direct, keeping())) {
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(proxy.exchanges().get(before).fromByte()).isZero();
    }

    @Test
    void shouldKeepNothingOfAnArchiveWithoutAHash() throws Exception {
        receive(served(), keeping(), 60_000);
        assertThat(folder.resolve("cache")).doesNotExist();
    }

    @Test
    void shouldLetTwoSessionsUseOneArchive() throws Exception {
        URI address = hashed(archive);
        receive(address, keeping(), 60_000);
        try (StreamingSession first = open(address, keeping())) {
            first.refine(200).join();
            try (StreamingSession second = open(address, keeping())) {
                assertThat(second.complete().join().identical()).isTrue();
            }
            assertThat(first.complete().join().identical()).isTrue();
        }
        assertThat(only(".jsm")).hasBinaryContent(archive);
        assertCompletes(address, keeping(), archive.length);
    }

    @Test
    void shouldDropTheLeastRecentlyUsed() throws IOException {
        SessionOptions small = keeping().withCacheBytes(archive.length * 2L + 1000);
        for (int i = 0; i < 3; i++) {
            byte[] other = FakeArchive.of(3000, 400_000, 10 + i);
            URI address = hashed(other);
            try (StreamingSession session = StreamingSession.open(
                    address, small, FakeArchive.decoder(FakeArchive.sha256(other)), heard, Runnable::run)) {
                assertThat(session.complete().join().identical()).isTrue();
            }
            // The clock of a file system may be coarse.
            for (Path log : all(".log")) {
                boolean own = log.getFileName().toString().startsWith(FakeArchive.sha256(other));
                if (own) Files.setLastModifiedTime(log, FileTime.fromMillis(1_000_000_000_000L + i * 1_000_000L));
            }
        }
        assertThat(all(".jsm")).hasSize(2);
        assertThat(all(".jsm").toString()).doesNotContain(FakeArchive.sha256(FakeArchive.of(3000, 400_000, 10)));
    }

    @Test
    void shouldStreamAsEverWhereNothingCanBeKept() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "no folder");
        assertCompletes(hashed(archive), QUICK.withCache(file), 0);
        assertThat(file).hasContent("no folder");
        SessionOptions tiny = QUICK.withCache(folder.resolve("tiny")).withCacheBytes(10_000);
        assertCompletes(hashed(archive), tiny, 0);
        try (Stream<Path> files = Files.list(folder.resolve("tiny"))) {
            assertThat(files.mapToLong(f -> f.toFile().length()).sum()).isLessThan(11_000);
        }
    }

    private Process otherProcess(URI address) throws IOException {
        return new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-Xmx64m",
                        "-cp",
                        System.getProperty("java.class.path"),
                        KilledSession.class.getName(),
                        address.toString(),
                        folder.resolve("cache").toString())
                .inheritIO()
                .start();
    }

    @Tag("slow")
    @Test
    void shouldReadWhatAnotherProcessIsWriting() throws Exception {
        URI address = hashed(archive);
        proxy.bytesPerSecond(100_000);
        Process child = otherProcess(address);
        try {
            Await.until("50,000 bytes for the other process", () -> sent() >= 50_000 || !child.isAlive());
            int before = proxy.exchanges().size();
            try (StreamingSession session = open(server.put(address.getPath(), archive), keeping())) {
                assertThat(session.complete().join().identical()).isTrue();
            }
            try (StreamingSession session = open(address, keeping())) {
                session.refine(500).join();
                assertThat(session.progress().bytes()).isGreaterThan(40_000);
            }
            assertThat(proxy.exchanges().get(before).fromByte()).isGreaterThan(40_000);
            assertThat(child.isAlive()).isTrue();
        } finally {
            child.destroyForcibly().waitFor();
        }
        proxy.bytesPerSecond(1e9);
        try (StreamingSession session = open(address, keeping())) {
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(all(".jsm")).hasSize(2).allSatisfy(f -> assertThat(f).hasBinaryContent(archive));
    }

    @Tag("slow")
    @Test
    void shouldLoseNothingWhenTheProcessIsKilled() throws Exception {
        URI address = hashed(archive);
        proxy.bytesPerSecond(200_000);
        Process child = otherProcess(address);
        try {
            Await.until("100,000 bytes for the other process", () -> sent() >= 100_000 || !child.isAlive());
        } finally {
            child.destroyForcibly().waitFor();
        }
        proxy.bytesPerSecond(1e9);
        long kept = Files.size(only(".jsm"));
        assertThat(kept).isBetween(1L, archive.length - 1L);
        int before = proxy.exchanges().size();
        try (StreamingSession session = open(address, keeping())) {
            assertThat(session.complete().join().identical()).isTrue();
        }
        // A part may have been written without its row in the log.
        assertThat(proxy.exchanges().get(before).fromByte()).isBetween(kept - (1 << 16), kept);
        assertThat(only(".jsm")).hasBinaryContent(archive);
    }

    private Path only(String end) throws IOException {
        assertThat(all(end)).hasSize(1);
        return all(end).get(0);
    }

    private List<Path> all(String end) throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve("cache"))) {
            return files.filter(f -> f.toString().endsWith(end)).toList();
        }
    }
}
