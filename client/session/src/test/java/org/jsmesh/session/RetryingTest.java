package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a listener hears of a connection that breaks, and the bytes that a session hands on. */
class RetryingTest extends SessionFixture {
    private record Pause(String reason, int attempt, long millis) {}

    private final List<Pause> pauses = new CopyOnWriteArrayList<>();
    private final SessionListener listener = new SessionListener() {
        @Override
        public void retrying(IOException error, int attempt, long pauseMillis) {
            pauses.add(new Pause(error.getMessage(), attempt, pauseMillis));
        }
    };

    @Test
    void shouldTellWhatFailedAndWhenItTriesAgain() throws IOException {
        ArrivedBytes arrived = new ArrivedBytes();
        server.failNext(2);
        try (StreamingSession session = open(QUICK.withArrived(arrived))) {
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(pauses).extracting(Pause::attempt).containsExactly(2, 3);
        assertThat(pauses).extracting(Pause::millis).containsExactly(5L, 10L);
        assertThat(pauses.get(0).reason()).contains("503");
        assertThat(all(arrived)).isEqualTo(archive);
    }

    @Test
    void shouldTryNowWhenItIsAsked() throws Exception {
        server.failNext(1);
        // Longer than the test may take.
        try (StreamingSession session = open(QUICK.withBackoffMillis(600_000))) {
            CompletableFuture<SessionResult> result = session.complete();
            Await.until("a pause", () -> !pauses.isEmpty());
            assertThat(result).isNotDone();
            session.tryNow();
            assertThat(result.join().identical()).isTrue();
        }
    }

    @Test
    void shouldSayThatTheRoundEndsBeforeTheNextAttempt() throws Exception {
        // The base has come by then. Either time is longer than the test may take.
        proxy.cutAfter(20_000);
        try (StreamingSession session = open(QUICK.withBackoffMillis(600_000))) {
            CompletableFuture<RoundReport> round = session.refine(300_000);
            Await.until("a pause", () -> !pauses.isEmpty());
            assertThat(pauses).extracting(Pause::millis).containsExactly(-1L);
            session.tryNow();
            round.join();
            assertThat(session.complete().join().identical()).isTrue();
        }
    }

    @Test
    void shouldHandOnWhatTheCacheHasToo(@TempDir Path folder) throws IOException {
        Path cache = Files.createDirectories(folder.resolve("cache"));
        ArrivedBytes first = new ArrivedBytes();
        ArrivedBytes second = new ArrivedBytes();
        for (ArrivedBytes arrived : List.of(first, second)) {
            try (StreamingSession session = open(QUICK.withCache(cache).withArrived(arrived))) {
                session.complete().join();
            }
        }
        assertThat(all(first)).isEqualTo(archive);
        assertThat(all(second)).isEqualTo(archive);
    }

    private StreamingSession open(SessionOptions options) {
        String hashed = "/" + FakeArchive.sha256(archive) + ".jsm";
        return StreamingSession.open(
                proxy.through(server.put(hashed, archive)),
                options,
                FakeArchive.decoder(FakeArchive.sha256(archive)),
                listener,
                Runnable::run);
    }

    private static byte[] all(ArrivedBytes arrived) throws IOException {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        arrived.writeTo(all);
        return all.toByteArray();
    }
}
