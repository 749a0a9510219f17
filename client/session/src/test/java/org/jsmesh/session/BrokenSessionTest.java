package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.session.testing.ProxiedExchange;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.session.testing.StaticFileServer;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Connections that break, servers that fail, and archives that are damaged or change. */
class BrokenSessionTest extends SessionFixture {
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
        List<ProxiedExchange> exchanges = proxy.exchanges();
        for (ProxiedExchange e : exchanges.subList(1, exchanges.size())) {
            assertThat(e.range()).startsWith("bytes=");
            assertThat(e.ifRange()).startsWith("\"").endsWith("\"");
            assertThat(e.status()).isEqualTo(206);
        }
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
    void shouldTryAgainWhenTheServerIsBusy() {
        URI address = served();
        server.failNext(3);
        try (StreamingSession session = open(address)) {
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(proxy.exchanges().stream().filter(e -> e.status() == 503)).hasSize(3);
    }

    @Test
    void shouldShowWhatIsThereWhileABusyServerIsLeftAlone() {
        URI address = served();
        proxy.cutAfter(20_000);
        SessionListener full = new SessionListener() {
            @Override
            public void progressed(SessionProgress now) {
                if (now.batches() > 0) server.failNext(1000, "600");
            }
        };
        try (StreamingSession session = StreamingSession.open(
                address, QUICK, FakeArchive.decoder(FakeArchive.sha256(archive)), full, Runnable::run)) {
            assertThat(session.refine(2000).join().batches()).isPositive();
            assertThat(server.requests().stream().filter(r -> r.status() == 503))
                    .hasSizeLessThan(2);
            assertThat(session.progress().isComplete()).isFalse();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"a.jsm", "manifest.json"})
    void shouldCancelWhileABusyServerIsLeftAlone(String file) throws Exception {
        server.failNext(1000, "30");
        try (StreamingSession session = open(proxy.through(server.put("/" + file, archive)))) {
            CompletableFuture<SessionResult> result = session.complete();
            Await.until("the first request", () -> !server.requests().isEmpty());
            session.cancel();
            assertThatThrownBy(result::join).isInstanceOf(CancellationException.class);
            assertThat(server.requests()).hasSize(1);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-1", "soon", "Wed, 21 Oct 2065 07:28:00 GMT", "99999999999"})
    void shouldPauseAsUsualWhenABusyServerSaysNothingSensible(String retryAfter) {
        URI address = served();
        server.failNext(3, retryAfter);
        try (StreamingSession session = open(address)) {
            assertThat(session.complete().join().identical()).isTrue();
        }
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
    void shouldTakeASilentConnectionForABrokenOne() throws Exception {
        URI address = served();
        proxy.bytesPerSecond(1);
        try (StreamingSession session = open(address, QUICK.withStallMillis(300).withAttempts(1000))) {
            CompletableFuture<SessionResult> complete = session.complete();
            Await.until("a second request", () -> proxy.exchanges().size() >= 2);
            proxy.bytesPerSecond(1e9);
            assertThat(complete.join().identical()).isTrue();
        }
    }
}
