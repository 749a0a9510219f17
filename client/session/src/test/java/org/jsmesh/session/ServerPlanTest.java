package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.net.URI;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.plan.BatchPlanner;
import org.jsmesh.session.testing.ProxiedExchange;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.session.testing.StaticFileServer;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ServerPlanTest {
    private static final Pattern PATCHES =
            Pattern.compile(".*/patches\\?from=(\\d+)&bytesPerSecond=(\\d+)&waitMillis=(\\d+)");
    private static final SessionOptions PLANNED =
            SessionOptions.defaults().withServerPlan(true).withBackoffMillis(5);
    private final byte[] archive = FakeArchive.of(3000, 400_000, 5);
    private final String hash = FakeArchive.sha256(archive);
    private BatchIndex index;
    private StaticFileServer server;
    private ShapingProxy proxy;
    private URI address;

    @BeforeEach
    void start() throws IOException, MalformedStreamException {
        MeshStream stream = FakeArchive.decoder("");
        stream.feed(archive, 0, archive.length);
        index = stream.header().batches();
        server = StaticFileServer.withRanges();
        proxy = ShapingProxy.to(server.port()).bytesPerSecond(200_000);
        address = proxy.through(server.put("/m/fake/" + hash + ".jsm", archive));
        server.handle("/m/fake/" + hash + "/patches", this::patches);
    }

    @AfterEach
    void stop() throws IOException {
        proxy.close();
        server.close();
    }

    private StreamingSession open(URI at) {
        return StreamingSession.open(at, PLANNED, FakeArchive.decoder(hash), SessionListener.NONE, Runnable::run);
    }

    /** What the servlet does. */
    private void patches(HttpExchange exchange) throws IOException {
        try (exchange) {
            Matcher m = PATCHES.matcher(exchange.getRequestURI().toString());
            assertThat(m.matches()).isTrue();
            int from = Integer.parseInt(m.group(1));
            int end = BatchPlanner.plan(index, from, Double.parseDouble(m.group(2)), Double.parseDouble(m.group(3)));
            byte[] body = Arrays.copyOfRange(archive, (int) index.offset(from), (int) index.end(end - 1));
            exchange.getResponseHeaders().set("Content-Location", "/m/fake/" + hash + "/batches/" + from + "-" + end);
            exchange.sendResponseHeaders(200, body.length);
            exchange.getResponseBody().write(body);
        }
    }

    private static void refineToTheEnd(StreamingSession session) throws Exception {
        Await.until("the last batch", () -> {
            session.refine(400).join();
            return session.progress().isComplete();
        });
    }

    @Test
    void shouldLetTheServerTurnBandwidthAndWaitIntoBatches() throws Exception {
        try (StreamingSession session = open(address)) {
            refineToTheEnd(session);
            assertThat(session.complete().join().identical()).isTrue();
        }
        List<ProxiedExchange> planned = proxy.exchanges().stream()
                .filter(e -> e.target().contains("/patches?"))
                .toList();
        assertThat(planned.size()).isGreaterThanOrEqualTo(2);
        // A round that is cancelled at its deadline leaves some bytes on the wire.
        assertThat(proxy.bodyBytes()).isBetween((long) archive.length, archive.length * 11L / 10);
    }

    @Test
    void shouldPlanWhatTheServerPlansAtTheSameEstimate() throws Exception {
        try (StreamingSession session = open(address)) {
            refineToTheEnd(session);
        }
        int compared = 0;
        for (ProxiedExchange e : proxy.exchanges()) {
            Matcher m = PATCHES.matcher(e.target());
            if (!m.matches()) continue;
            int from = Integer.parseInt(m.group(1));
            int end = BatchPlanner.planFromByte(
                    index, index.offset(from), Double.parseDouble(m.group(2)), Double.parseDouble(m.group(3)));
            assertThat(e.bodyBytes()).isLessThanOrEqualTo(index.end(end - 1) - index.offset(from));
            compared++;
        }
        assertThat(compared).isGreaterThanOrEqualTo(2);
    }

    @Test
    void shouldResumeWhatTheServerPlanned() {
        proxy.bytesPerSecond(1e9).cutAfter(50_000);
        try (StreamingSession session = open(address)) {
            session.refine(2000).join();
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(proxy.exchanges()).anyMatch(e -> e.target().contains("/patches?"));
        assertThat(proxy.bodyBytes()).isEqualTo(archive.length);
    }

    @Test
    void shouldSayThatAHostDoesNotPlan() {
        try (StreamingSession session = open(server.put("/plain.jsm", archive))) {
            assertThatThrownBy(() -> session.refine(500).join())
                    .hasCauseInstanceOf(FetchException.class)
                    .hasMessageContaining("let the client plan");
        }
    }
}
