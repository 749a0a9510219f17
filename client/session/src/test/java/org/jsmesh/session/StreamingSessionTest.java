package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.session.testing.Exchange;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.session.testing.StaticFileServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(60)
class StreamingSessionTest {
    private static final SessionOptions QUICK =
            SessionOptions.defaults().withBackoffMillis(5).withMeshMillis(0);
    private final byte[] archive = FakeArchive.of(3000, 400_000, 1);
    private final Recording heard = new Recording();
    private StaticFileServer server;
    private ShapingProxy proxy;

    @BeforeEach
    void start() throws IOException {
        server = StaticFileServer.withRanges();
        proxy = ShapingProxy.to(server.port());
    }

    @AfterEach
    void stop() throws IOException {
        proxy.close();
        server.close();
    }

    private StreamingSession open(URI address) {
        return open(address, QUICK);
    }

    private StreamingSession open(URI address, SessionOptions options) {
        return StreamingSession.open(
                address, options, FakeArchive.decoder(FakeArchive.sha256(archive)), heard, Runnable::run);
    }

    private URI served() {
        return proxy.through(server.put("/a.jsm", archive));
    }

    @Test
    void shouldBringTheOriginalAndProveIt() {
        try (StreamingSession session = open(served())) {
            SessionResult result = session.complete().join();
            assertThat(result.identical()).isTrue();
            assertThat(result.archiveSha256()).isEqualTo(FakeArchive.sha256(archive));
            assertThat(session.progress().isComplete()).isTrue();
            assertThat(session.progress().fraction()).isEqualTo(1);
            assertThat(heard.events).containsExactly("opened", "base", "round", "identical");
            assertTiling(proxy.exchanges(), archive.length);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void shouldResumeWhereTheConnectionBreaks(long seed) {
        Random random = new Random(seed);
        URI address = served();
        proxy.cutAfter(random.nextInt(archive.length));
        try (StreamingSession session = open(address)) {
            if (random.nextBoolean()) session.refine(300).join();
            CompletableFuture<SessionResult> result = session.complete();
            assertThat(result.join().identical()).isTrue();
        }
        assertTiling(proxy.exchanges(), archive.length);
        List<Exchange> exchanges = proxy.exchanges();
        for (Exchange e : exchanges.subList(1, exchanges.size())) {
            assertThat(e.range()).startsWith("bytes=");
            assertThat(e.ifRange()).startsWith("\"").endsWith("\"");
            assertThat(e.status()).isEqualTo(206);
        }
    }

    @Test
    void shouldAskForAnUnknownHostOnce() throws Exception {
        SessionOptions patient = SessionOptions.defaults().withBackoffMillis(600_000);
        for (String file : new String[] {"a.jsm", "manifest.json"}) {
            URI nowhere = URI.create("http://nonexistent.invalid/" + file);
            try (StreamingSession session = open(nowhere, patient)) {
                assertThatThrownBy(() -> session.complete().get(30, TimeUnit.SECONDS))
                        .cause()
                        .isInstanceOf(FetchException.class)
                        .hasMessageContaining(nowhere + ": the host is unknown");
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"http://127.0.0.1:99999/a", "file:relative.jsm", "ftp://127.0.0.1/a"})
    void shouldRefuseAnImpossibleAddressAtOnce(String address) {
        assertThatThrownBy(() -> open(URI.create(address)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(address);
    }

    @Test
    void shouldResumeManyTimes() {
        URI address = served();
        Random random = new Random(11);
        heard.events.clear();
        List<Integer> cuts = new ArrayList<>();
        SessionListener cutter = new SessionListener() {
            @Override
            public void progressed(SessionProgress now) {
                if (now.bytes() - (cuts.isEmpty() ? 0 : cuts.get(cuts.size() - 1)) < 40_000) return;
                cuts.add((int) now.bytes());
                proxy.cutAfter(1 + random.nextInt(20_000));
            }
        };
        proxy.bytesPerSecond(2_000_000);
        try (StreamingSession session = StreamingSession.open(
                address, QUICK, FakeArchive.decoder(FakeArchive.sha256(archive)), cutter, Runnable::run)) {
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(cuts.size()).isGreaterThan(3);
        assertThat(proxy.exchanges().size()).isGreaterThan(3);
        assertTiling(proxy.exchanges(), archive.length);
    }

    @Test
    void shouldRefineInRoundsThatFitTheWait() {
        URI address = served();
        proxy.bytesPerSecond(100_000);
        try (StreamingSession session = open(address)) {
            RoundReport first = session.refine(500).join();
            RoundReport second = session.refine(500).join();
            assertThat(first.batches()).isPositive();
            assertThat(second.batches()).isGreaterThan(first.batches());
            assertThat(second.faces()).isGreaterThan(first.faces());
            assertThat(second.errorMean()).isLessThan(first.errorMean());
            assertThat(session.progress().isComplete()).isFalse();
            assertThat(second.plannedBytes()).isLessThan(150_000);
        }
        assertThat(proxy.exchanges()).allMatch(e -> e.range().matches("bytes=\\d+-\\d+"));
        assertThat(heard.events).startsWith("opened", "base", "round", "round");
        assertThat(heard.facesShown).isSorted();
    }

    @Test
    void shouldAskForMoreWhenTheLinkGetsFaster() {
        URI address = proxy.through(server.put("/large.jsm", FakeArchive.of(3000, 4_000_000, 2)));
        proxy.bytesPerSecond(60_000);
        try (StreamingSession session = open(address)) {
            session.refine(600).join();
            RoundReport slow = session.refine(600).join();
            proxy.bytesPerSecond(1_200_000);
            RoundReport fast = refineUntil(session, round -> round.plannedBytes() > 2 * slow.plannedBytes());
            assertThat(fast.plannedBytes()).isGreaterThan(2 * slow.plannedBytes());
            proxy.bytesPerSecond(60_000);
            RoundReport slowAgain = refineUntil(session, round -> round.plannedBytes() < fast.plannedBytes() / 2);
            assertThat(slowAgain.plannedBytes()).isLessThan(fast.plannedBytes() / 2);
        }
    }

    /** The estimate is a mean, and a busy machine delays what it measures: it may take some rounds to follow. */
    private static RoundReport refineUntil(StreamingSession session, Predicate<RoundReport> followed) {
        RoundReport round = session.refine(600).join();
        for (int i = 0; i < 5 && !followed.test(round); i++)
            round = session.refine(600).join();
        return round;
    }

    @Test
    void shouldOpenAManifest() {
        String hash = FakeArchive.sha256(archive);
        server.put("/m/fake/" + hash + ".jsm", archive);
        URI manifest = proxy.through(server.put(
                "/m/fake/manifest.json", manifest(hash + ".jsm", hash, hash).getBytes(), "application/json", null));
        try (StreamingSession session = open(manifest)) {
            session.refine(500).join();
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(proxy.exchanges().get(0).target()).isEqualTo("/m/fake/manifest.json");
        assertTiling(proxy.exchanges().subList(1, proxy.exchanges().size()), archive.length);
    }

    @Test
    void shouldKnowAManifestByItsType() {
        String hash = FakeArchive.sha256(archive);
        server.put("/m/fake/" + hash + ".jsm", archive);
        URI manifest = server.put(
                "/m/fake",
                manifest("fake/" + hash + ".jsm", hash, hash).getBytes(),
                "application/json; charset=utf-8",
                null);
        try (StreamingSession session = open(manifest)) {
            assertThat(session.complete().join().identical()).isTrue();
        }
    }

    @Test
    void shouldNotCallAnotherArchiveIdentical() {
        String other = FakeArchive.sha256(new byte[0]);
        URI address = server.put("/m/fake/" + other + ".jsm", archive);
        try (StreamingSession session = open(address)) {
            SessionResult result = session.complete().join();
            assertThat(result.identical()).isFalse();
            assertThat(result.difference()).contains(other);
        }
        String hash = FakeArchive.sha256(archive);
        URI manifest = server.put(
                "/m/fake/manifest.json",
                manifest("/m/fake/" + other + ".jsm", hash, other).getBytes(),
                "application/json",
                null);
        try (StreamingSession session = open(manifest)) {
            SessionResult result = session.complete().join();
            assertThat(result.identical()).isFalse();
            assertThat(result.difference()).contains("manifest").contains(other);
        }
    }

    private static String manifest(String url, String archiveHash, String meshHash) {
        return "{\"archiveUrl\":\"" + url + "\",\"archiveSha256\":\"" + archiveHash + "\",\"meshSha256\":\"" + meshHash
                + "\",\"batches\":[{\"bytes\":3000},{\"bytes\":1024}]}";
    }

    @Test
    void shouldStreamFromAServerWithoutRanges() throws IOException {
        try (StaticFileServer plain = StaticFileServer.withoutRanges();
                ShapingProxy slow = ShapingProxy.to(plain.port()).bytesPerSecond(200_000)) {
            URI address = slow.through(plain.put("/a.jsm", archive));
            try (StreamingSession session = open(address)) {
                RoundReport first = session.refine(400).join();
                assertThat(first.batches()).isPositive();
                assertThat(session.progress().isComplete()).isFalse();
                RoundReport second = session.refine(400).join();
                assertThat(second.bytes()).isPositive();
                assertThat(session.complete().join().identical()).isTrue();
            }
            assertThat(slow.exchanges()).hasSize(1);
            assertThat(slow.bodyBytes()).isEqualTo(archive.length);
        }
    }

    @Test
    void shouldBeginAgainButCheckWhatItHasWhenTheServerHasNoRanges() throws IOException {
        try (StaticFileServer plain = StaticFileServer.withoutRanges();
                ShapingProxy cutting = ShapingProxy.to(plain.port()).cutAfter(100_000)) {
            URI address = cutting.through(plain.put("/a.jsm", archive, "application/octet-stream", null));
            try (StreamingSession session = open(address)) {
                assertThat(session.complete().join().identical()).isTrue();
            }
            byte[] changed = archive.clone();
            changed[10]++;
            cutting.cutAfter(100_000);
            try (StreamingSession session = StreamingSession.open(
                    address,
                    QUICK,
                    FakeArchive.decoder(""),
                    new SessionListener() {
                        @Override
                        public void progressed(SessionProgress now) {
                            plain.put("/a.jsm", changed, "application/octet-stream", null);
                        }
                    },
                    Runnable::run)) {
                assertFailure(session, ArchiveChangedException.class, "changed");
            }
        }
    }

    @Test
    void shouldSayThatTheArchiveChanged() {
        URI address = served();
        try (StreamingSession session = open(address)) {
            proxy.bytesPerSecond(200_000);
            session.refine(300).join();
            server.put("/a.jsm", FakeArchive.of(3000, 400_000, 99));
            assertFailure(session, ArchiveChangedException.class, "open it again");
            assertFailure(session, ArchiveChangedException.class, "open it again");
        }
    }

    @Test
    void shouldNeverCallDamagedBytesIdentical() {
        URI address = served();
        proxy.corruptByte(123_456);
        try (StreamingSession session = open(address)) {
            assertFailure(session, MalformedStreamException.class, "damaged");
            assertThat(session.result()).isNull();
            assertThat(session.progress().batches()).isPositive();
        }
        assertThat(heard.events).contains("base", "failed").doesNotContain("identical", "different");
    }

    @Test
    void shouldSayThatAnArchiveIsCutOff() {
        byte[] half = java.util.Arrays.copyOf(archive, 200_000);
        try (StreamingSession session = open(server.put("/half.jsm", half))) {
            assertFailure(session, MalformedStreamException.class, "cut off");
            assertThat(session.progress().batches()).isPositive();
        }
    }

    @Test
    void shouldSayWhatIsWrongWithAnAddress() {
        try (StreamingSession session = open(server.put("/x.jsm", archive).resolve("/missing.jsm"))) {
            assertFailure(session, FetchException.class, "404");
        }
        try (StreamingSession session = open(server.put("/page", "<html>".getBytes(), "text/html", null))) {
            assertFailure(session, FetchException.class, "is a page");
        }
        try (StreamingSession session = open(server.put("/bad.json", "{}".getBytes(), "application/json", null))) {
            assertFailure(session, FetchException.class, "archiveUrl");
        }
        try (StreamingSession session = open(server.put(
                "/evil.json",
                manifest("file:///etc/passwd", "0".repeat(64), "0".repeat(64)).getBytes(),
                "application/json",
                null))) {
            assertFailure(session, FetchException.class, "neither http nor https");
        }
        assertThatThrownBy(() -> open(URI.create("ftp://host/a.jsm")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("ftp://host/a.jsm");
    }

    @Test
    void shouldTryAgainWhenTheServerIsBusy() {
        URI address = served();
        server.failNext(3);
        try (StreamingSession session = open(address)) {
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(proxy.exchanges().stream().filter(e -> e.status() == 503)).hasSize(3);
    }

    @Test
    void shouldGiveUpWhenNobodyAnswersAndGoOnWhenAskedAgain() {
        URI address = served();
        server.failNext(3);
        try (StreamingSession session = open(address, QUICK.withAttempts(3))) {
            assertFailure(session, FetchException.class, "503");
            assertThat(session.complete().join().identical()).isTrue();
        }
    }

    @Test
    void shouldGiveUpWhenThereIsNoServer() throws IOException {
        StaticFileServer gone = StaticFileServer.withRanges();
        URI address = gone.put("/a.jsm", archive);
        gone.close();
        try (StreamingSession session = open(address, QUICK.withAttempts(2))) {
            assertFailure(session, FetchException.class, "check the network");
        }
    }

    @Test
    void shouldTakeASilentConnectionForABrokenOne() {
        URI address = served();
        proxy.bytesPerSecond(1);
        try (StreamingSession session = open(address, QUICK.withStallMillis(300).withAttempts(1000))) {
            CompletableFuture<SessionResult> complete = session.complete();
            while (proxy.exchanges().size() < 2) Thread.onSpinWait();
            proxy.bytesPerSecond(1e9);
            assertThat(complete.join().identical()).isTrue();
        }
    }

    @Test
    void shouldQueueRoundsThatAreAskedForAtOnce() {
        URI address = served();
        proxy.bytesPerSecond(100_000);
        try (StreamingSession session = open(address)) {
            CompletableFuture<RoundReport> first = session.refine(400);
            CompletableFuture<RoundReport> second = session.refine(400);
            assertThat(second.join().batches()).isGreaterThan(first.join().batches());
        }
    }

    @Test
    void shouldCancelAndGoOn() {
        URI address = served();
        proxy.bytesPerSecond(50_000);
        try (StreamingSession session = open(address)) {
            session.refine(300).join();
            CompletableFuture<SessionResult> complete = session.complete();
            long before = session.progress().bytes();
            while (session.progress().bytes() == before) Thread.onSpinWait();
            session.cancel();
            assertThatThrownBy(complete::join).isInstanceOf(CancellationException.class);
            long kept = session.progress().bytes();
            assertThat(kept).isPositive();
            proxy.bytesPerSecond(1e9);
            assertThat(session.complete().join().identical()).isTrue();
        }
    }

    @Test
    void shouldRefuseCallsAfterClose() {
        StreamingSession session = open(served());
        session.close();
        assertThatThrownBy(() -> session.refine(100)).isInstanceOf(IllegalStateException.class);
        session.close();
    }

    @Test
    void shouldOpenLocalFiles(@TempDir Path folder) throws IOException {
        Path file = Files.write(folder.resolve("a b.jsm"), archive);
        try (StreamingSession session = open(file.toUri())) {
            RoundReport first = session.refine(2000).join();
            assertThat(first.batches()).isPositive();
            assertThat(session.complete().join().identical()).isTrue();
        }
        try (StreamingSession session = open(folder.resolve("none.jsm").toUri())) {
            assertFailure(session, FetchException.class, "does not exist");
        }
    }

    @Test
    void shouldTraceRoundsAndRequests() throws IOException {
        URI address = served();
        proxy.bytesPerSecond(200_000);
        try (StreamingSession session = open(address)) {
            session.refine(400).join();
            session.complete().join();
            SessionTrace trace = session.trace();
            assertThat(trace.rounds()).hasSize(2);
            assertThat(trace.rounds().stream().mapToLong(RoundReport::bytes).sum())
                    .isEqualTo(archive.length);
            assertThat(trace.requests().stream().mapToLong(RequestReport::bytes).sum())
                    .isEqualTo(archive.length);
            assertThat(trace.requests())
                    .allMatch(r -> r.startMillis() <= r.firstByteMillis() && r.firstByteMillis() <= r.endMillis());
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            trace.writeJson(out);
            JsonNode json = new ObjectMapper().readTree(out.toByteArray());
            assertThat(json.fieldNames()).toIterable().containsExactly("rounds", "requests");
            assertThat(json.path("rounds").get(0).fieldNames())
                    .toIterable()
                    .containsExactly(
                            "waitMillis",
                            "plannedWaitMillis",
                            "plannedBytes",
                            "bytes",
                            "bytesPerSecond",
                            "batches",
                            "faces",
                            "errorMean");
            assertThat(json.path("requests").get(0).fieldNames())
                    .toIterable()
                    .containsExactly("url", "range", "startMillis", "firstByteMillis", "endMillis", "bytes");
            assertThat(json.path("rounds").get(0).path("plannedWaitMillis").asInt())
                    .isEqualTo(400);
        }
    }

    private static void assertFailure(StreamingSession session, Class<? extends IOException> type, String words) {
        assertThatThrownBy(() -> session.complete().join())
                .isInstanceOf(CompletionException.class)
                .hasCauseInstanceOf(type)
                .cause()
                .hasMessageContaining(words);
    }

    /** The bodies passed on cover the file once: none of its bytes twice. */
    static void assertTiling(List<Exchange> exchanges, long fileBytes) {
        List<Exchange> bodies = new ArrayList<>(exchanges);
        bodies.removeIf(e -> e.bodyBytes() == 0);
        bodies.sort(Comparator.comparingLong(Exchange::fromByte));
        long at = 0;
        for (Exchange e : bodies) {
            assertThat(e.fromByte()).as("%s after byte %d", e, at).isEqualTo(at);
            at += e.bodyBytes();
        }
        assertThat(at).isEqualTo(fileBytes);
    }
}
