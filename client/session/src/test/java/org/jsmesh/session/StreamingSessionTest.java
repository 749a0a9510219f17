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
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.function.Predicate;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a session does as long as nothing goes wrong. */
class StreamingSessionTest extends SessionFixture {
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
    void shouldCancelAndGoOn() throws Exception {
        URI address = served();
        proxy.bytesPerSecond(50_000);
        try (StreamingSession session = open(address)) {
            session.refine(300).join();
            CompletableFuture<SessionResult> complete = session.complete();
            long before = session.progress().bytes();
            Await.until("more bytes", () -> session.progress().bytes() > before);
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
                    .containsExactly("url", "range", "startMillis", "firstByteMillis", "endMillis", "bytes", "http2");
            assertThat(json.path("rounds").get(0).path("plannedWaitMillis").asInt())
                    .isEqualTo(400);
        }
    }
}
