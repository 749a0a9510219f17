package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.Socket;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.app.Cli;
import org.jsmesh.app.TestKeystore;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What goes beyond the limits is told to come again, and what is within them is served. */
@Tag("slow")
class LimitsTest extends GuardedServer {
    private static final int LOOKS = 60;

    private final List<Socket> open = new ArrayList<>();

    @AfterEach
    void closeSockets() throws Exception {
        for (Socket socket : open) socket.close();
    }

    private Socket keep(Socket socket) {
        open.add(socket);
        return socket;
    }

    /** A reader that takes nothing keeps one request running. */
    private Socket stuck(String... fields) throws Exception {
        Socket socket = keep(connect());
        String more = String.join("", fields);
        send(socket, requestLarge().replace("Host: h\r\n", "Host: h\r\n" + more));
        return socket;
    }

    /**
     * Waits until a metric has a value and keeps it: what is being sent ends sooner or later at a reader that takes
     * nothing.
     */
    private void await(String metric, int value) throws Exception {
        AtomicInteger times = new AtomicInteger();
        Await.until(metric + " to stay at " + value, () -> {
            if (!metricIs(metric, value)) times.set(0);
            return times.incrementAndGet() > LOOKS;
        });
    }

    private boolean metricIs(String name, int value) {
        return server.metrics().text().lines().anyMatch(line -> line.equals(name + " " + value + ".0"));
    }

    private String ask(String... fields) throws Exception {
        return exchange("GET " + archivePath + " HTTP/1.1\r\nHost: h\r\nConnection: close\r\n" + String.join("", fields)
                + "\r\n");
    }

    private static void assertToldToComeAgain(String answer) throws Exception {
        assertThat(answer).startsWith("HTTP/1.1 503").contains("\r\nRetry-After: ", "{\"error\":\"");
    }

    @Test
    void shouldTellConnectionsBeyondTheLimitToComeAgain() throws Exception {
        start(ServerSettings.defaults().withLimits(Limits.defaults().withConnections(3, 100)));
        for (int i = 0; i < 3; i++) keep(connect());
        await("jsm_connections", 3);
        assertToldToComeAgain(ask());
        open.get(0).close();
        await("jsm_connections", 2);
        assertThat(ask()).startsWith("HTTP/1.1 200");
    }

    @Test
    void shouldLetPagesOfTheChosenOriginsReadWhenToComeAgain() throws Exception {
        start(ServerSettings.defaults()
                .withOrigins(List.of("https://a.example"))
                .withLimits(Limits.defaults().withConnections(1, 100)));
        keep(connect());
        await("jsm_connections", 1);
        assertThat(ask("Origin: https://a.example\r\n"))
                .startsWith("HTTP/1.1 503")
                .contains("Access-Control-Allow-Origin: https://a.example\r\n")
                .contains("Access-Control-Expose-Headers: Retry-After\r\n");
        await("jsm_connections", 1);
        assertThat(ask("Origin: https://b.example\r\n"))
                .startsWith("HTTP/1.1 503")
                .doesNotContain("Access-Control-Allow-Origin");
    }

    @Test
    void shouldServeAConnectionOfHttp2OnceThereIsRoom(@TempDir Path keys) throws Exception {
        TestKeystore keystore = TestKeystore.in(keys);
        start(ServerSettings.defaults()
                .withKeystore(keystore.file(), keystore.password())
                .withLimits(Limits.defaults().withConnections(1, 100)));
        keep(connect());
        await("jsm_connections", 1);
        HttpClient client =
                HttpClient.newBuilder().sslContext(keystore.trusting()).build();
        HttpRequest request =
                HttpRequest.newBuilder(server.uri().resolve(archivePath)).build();
        HttpResponse<byte[]> refused = client.send(request, HttpResponse.BodyHandlers.ofByteArray());
        assertThat(refused.version()).isEqualTo(HttpClient.Version.HTTP_2);
        assertThat(refused.statusCode()).isEqualTo(503);
        open.get(0).close();
        await("jsm_connections", 1);
        // On the connection that was one too many before.
        assertThat(client.send(request, HttpResponse.BodyHandlers.ofByteArray()).statusCode())
                .isEqualTo(200);
    }

    @Test
    void shouldCloseConnectionsOfOneAddressBeyondTheLimit() throws Exception {
        start(ServerSettings.defaults().withLimits(Limits.defaults().withConnections(100, 2)));
        for (int i = 0; i < 2; i++) keep(connect());
        await("jsm_connections", 2);
        try (Socket third = connect()) {
            assertThat(readToEnd(third)).isEmpty();
        }
        open.get(0).close();
        await("jsm_connections", 1);
        assertThat(ask()).startsWith("HTTP/1.1 200");
    }

    @Test
    void shouldLimitTheRequestsOfAnAddress() throws Exception {
        start(ServerSettings.defaults().withLimits(Limits.defaults().withRequestsPerAddress(2)));
        for (int i = 0; i < 2; i++) stuck();
        await("jsm_requests_running", 2);
        assertToldToComeAgain(ask());
        for (Socket socket : open) socket.close();
        await("jsm_requests_running", 0);
        assertStillServes();
    }

    @Test
    void shouldTellAddressesThatAskTooFastToComeAgain(@TempDir Path keys) throws Exception {
        TestKeystore keystore = TestKeystore.in(keys);
        start(ServerSettings.defaults()
                .withKeystore(keystore.file(), keystore.password())
                .withOrigins(List.of("https://a.example"))
                .withProxies(List.of("127.0.0.1"))
                .withLimits(Limits.defaults().withRequestRate(1, 3)));
        for (HttpClient.Version version : HttpClient.Version.values()) {
            HttpClient client = HttpClient.newBuilder()
                    .sslContext(keystore.trusting())
                    .version(version)
                    .build();
            HttpRequest.Builder request = HttpRequest.newBuilder(server.uri().resolve(archivePath))
                    .header("Origin", "https://a.example")
                    .header("X-Forwarded-For", "192.0.2." + version.ordinal());
            List<HttpResponse<byte[]>> refused = new ArrayList<>();
            for (int i = 0; i < 1000 && refused.isEmpty(); i++) {
                HttpResponse<byte[]> answer = client.send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
                assertThat(answer.version()).isEqualTo(version);
                if (answer.statusCode() != 200) refused.add(answer);
            }
            assertThat(refused).hasSize(1);
            HttpResponse<byte[]> answer = refused.get(0);
            assertThat(answer.statusCode()).isEqualTo(429);
            assertThat(answer.headers().firstValue("Retry-After")).contains("1");
            assertThat(answer.headers().firstValue("Access-Control-Expose-Headers"))
                    .contains("Retry-After");
            assertThat(new String(answer.body(), StandardCharsets.UTF_8)).contains("asks too fast", "remedy");
            request.setHeader("X-Forwarded-For", "192.0.2.9");
            if (version == HttpClient.Version.HTTP_1_1)
                assertThat(client.send(request.build(), HttpResponse.BodyHandlers.ofByteArray())
                                .statusCode())
                        .isEqualTo(200);
        }
        assertThat(server.metrics().text()).contains("jsm_rate_refused_total 2.0");
    }

    @Test
    void shouldBelieveTrustedProxiesAlone() throws Exception {
        Limits limits = Limits.defaults().withRequestsPerAddress(1);
        start(ServerSettings.defaults().withLimits(limits));
        stuck("X-Forwarded-For: 192.0.2.1\r\n");
        await("jsm_requests_running", 1);
        assertToldToComeAgain(ask("X-Forwarded-For: 192.0.2.2\r\n"));
        closeSockets();

        start(ServerSettings.defaults().withLimits(limits).withProxies(List.of("127.0.0.0/8")));
        stuck("X-Forwarded-For: 192.0.2.1\r\n");
        await("jsm_requests_running", 1);
        assertThat(ask("X-Forwarded-For: 192.0.2.2\r\n")).startsWith("HTTP/1.1 200");
        assertToldToComeAgain(ask("X-Forwarded-For: 192.0.2.1\r\n"));
        // Anybody may write what stands in front of the last address that a trusted proxy appended.
        assertToldToComeAgain(ask("X-Forwarded-For: 192.0.2.9, 192.0.2.1\r\n"));
        assertToldToComeAgain(ask("X-Forwarded-For: 192.0.2.1, 127.0.0.7\r\n"));
        // Some proxies append a field of their own.
        assertToldToComeAgain(ask("X-Forwarded-For: 192.0.2.9\r\nX-Forwarded-For: 192.0.2.1\r\n"));
        assertThat(ask("X-Forwarded-For: nonsense\r\n")).startsWith("HTTP/1.1 200");
    }

    @Test
    void shouldCountAnIpv6NetworkAsOne() throws Exception {
        Limits limits = Limits.defaults().withRequestsPerAddress(1);
        start(ServerSettings.defaults().withLimits(limits).withProxies(List.of("127.0.0.1")));
        stuck("X-Forwarded-For: 2001:db8::1\r\n");
        await("jsm_requests_running", 1);
        assertToldToComeAgain(ask("X-Forwarded-For: 2001:db8::ffff:2\r\n"));
        assertThat(ask("X-Forwarded-For: 2001:db8:0:1::1\r\n")).startsWith("HTTP/1.1 200");
    }

    @Test
    void shouldRefuseLimitsThatServeNobody() {
        assertThatThrownBy(() -> Limits.defaults().withConnections(0, 1))
                .hasMessageContaining("--max-connections is 0");
        Cli cli = Cli.run("serve", folder, "--max-header-bytes", "10");
        assertThat(cli.code()).isEqualTo(2);
        assertThat(cli.err()).contains("--max-header-bytes is 10").hasLineCount(1);
        Cli rate = Cli.run("serve", folder, "--request-burst", "0");
        assertThat(rate.code()).isEqualTo(2);
        assertThat(rate.err()).contains("--request-burst is 0").hasLineCount(1);
        Cli proxy = Cli.run("serve", folder, "--trust-proxy", "somebody:1/99");
        assertThat(proxy.code()).isEqualTo(2);
        assertThat(proxy.err()).contains("--trust-proxy").hasLineCount(1);
    }
}
