package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.URI;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CompletionException;
import org.jsmesh.session.testing.ProxiedExchange;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.session.testing.StaticFileServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;

/** A session with a made-up archive, served through a proxy that can be slow, break or damage. */
@Timeout(60)
abstract class SessionFixture {
    static final SessionOptions QUICK =
            SessionOptions.defaults().withBackoffMillis(5).withMeshMillis(0);
    final byte[] archive = FakeArchive.of(3000, 400_000, 1);
    final Recording heard = new Recording();
    StaticFileServer server;
    ShapingProxy proxy;

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

    StreamingSession open(URI address) {
        return open(address, QUICK);
    }

    StreamingSession open(URI address, SessionOptions options) {
        return StreamingSession.open(
                address, options, FakeArchive.decoder(FakeArchive.sha256(archive)), heard, Runnable::run);
    }

    URI served() {
        return proxy.through(server.put("/a.jsm", archive));
    }

    static void assertFailure(StreamingSession session, Class<? extends IOException> type, String words) {
        assertThatThrownBy(() -> session.complete().join())
                .isInstanceOf(CompletionException.class)
                .hasCauseInstanceOf(type)
                .cause()
                .hasMessageContaining(words);
    }

    /** The bodies passed on cover the file once: none of its bytes twice. */
    static void assertTiling(List<ProxiedExchange> exchanges, long fileBytes) {
        List<ProxiedExchange> bodies = new ArrayList<>(exchanges);
        bodies.removeIf(e -> e.bodyBytes() == 0);
        bodies.sort(Comparator.comparingLong(ProxiedExchange::fromByte));
        long at = 0;
        for (ProxiedExchange e : bodies) {
            assertThat(e.fromByte()).as("%s after byte %d", e, at).isEqualTo(at);
            at += e.bodyBytes();
        }
        assertThat(at).isEqualTo(fileBytes);
    }
}
