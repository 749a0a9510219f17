package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** Manifests that are made while they are asked for, and answers that never become one. */
class ManifestRequestTest extends SessionFixture {
    private static final String ADDRESS = "/m/fake/manifest.json";

    private String manifest() {
        String hash = FakeArchive.sha256(archive);
        return "{\"archiveUrl\":\"/a.jsm\",\"archiveSha256\":\"" + hash + "\",\"meshSha256\":\"" + hash + "\"}";
    }

    private static void answer(HttpExchange exchange, int status, String body) throws IOException {
        try (exchange) {
            byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
            exchange.getResponseHeaders().set("Content-Type", "application/json");
            exchange.sendResponseHeaders(status, bytes.length);
            exchange.getResponseBody().write(bytes);
        }
    }

    @Test
    void shouldFollowAServerThatEncodesTheModelFirst() {
        AtomicInteger asked = new AtomicInteger();
        server.put("/a.jsm", archive);
        URI address = server.handle(ADDRESS, exchange -> {
            int number = asked.incrementAndGet();
            String state = "{\"state\":\"preparing\",\"stage\":\"simplify\",\"fraction\":0." + number + "}";
            if (number < 4) answer(exchange, 202, state);
            else answer(exchange, 200, manifest());
        });
        try (StreamingSession session = open(address)) {
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(heard.events.subList(0, 4))
                .containsExactly("simplify 10%", "simplify 20%", "simplify 30%", "opened");
        assertThat(asked.get()).isEqualTo(4);
    }

    @Test
    void shouldSayWhenPreparingFails() {
        AtomicInteger asked = new AtomicInteger();
        URI address = server.handle(
                ADDRESS, exchange -> answer(exchange, asked.incrementAndGet() < 3 ? 202 : 422, "no state"));
        try (StreamingSession session = open(address)) {
            assertFailure(session, FetchException.class, "the server answers 422");
        }
        assertThat(heard.events).startsWith("waiting 0%", "waiting 0%");
    }

    @Test
    void shouldGiveUpAnAnswerThatDoesNotEnd() {
        URI address = server.handle(ADDRESS, exchange -> {
            try (exchange) {
                exchange.sendResponseHeaders(200, 0);
                byte[] block = new byte[1 << 16];
                OutputStream out = exchange.getResponseBody();
                while (true) out.write(block);
            }
        });
        try (StreamingSession session = open(address)) {
            assertFailure(session, FetchException.class, "is too large for a manifest");
        }
    }

    @Test
    void shouldGiveUpAnAnswerThatStopsComing() {
        URI address = server.handle(ADDRESS, exchange -> {
            exchange.sendResponseHeaders(200, 0);
            exchange.getResponseBody().write('{');
            exchange.getResponseBody().flush();
            // Nothing more comes; the server ends with the test.
        });
        try (StreamingSession session = open(address, QUICK.withStallMillis(200).withAttempts(2))) {
            assertFailure(session, FetchException.class, "the answer does not come");
        }
    }
}
