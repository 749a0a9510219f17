package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.net.ConnectException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jsmesh.app.Jsm;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What whoever runs a server sees of it: the log, the metrics, and how it ends. */
class OperationTest extends GuardedServer {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path logs;

    private HttpResponse<byte[]> get(String path, String... headers) throws Exception {
        HttpRequest.Builder request = HttpRequest.newBuilder(server.uri().resolve(path));
        if (headers.length > 0) request.headers(headers);
        HttpClient client =
                HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
        return client.send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
    }

    private static List<JsonNode> lines(Path file) throws IOException {
        List<JsonNode> lines = new ArrayList<>();
        for (String line : Files.readAllLines(file)) lines.add(JSON.readTree(line));
        return lines;
    }

    @Test
    void shouldLogEveryRequestInALineOfJson() throws Exception {
        Path file = logs.resolve("access.json");
        try (AccessLog log = AccessLog.to(file)) {
            start(ServerSettings.defaults(), log);
            get(archivePath, "Range", "bytes=0-99");
            get("/m/nobody/manifest.json?a=b");
            exchange("GET /m/%22%5C%0A HTTP/1.1\r\nHost: h\r\nRange: \"\\\u001b[2J\r\nConnection: close\r\n\r\n");
            exchange("GET /m/\" HTTP/1.1\r\nHost: h\r\nRange: \"\\\u00ff\r\nConnection: close\r\n\r\n");
            stop();
        }
        List<JsonNode> lines = lines(file);
        JsonNode part = lines.get(0);
        assertThat(part.get("time").asText()).matches("\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d(\\.\\d{3})?Z");
        assertThat(part.get("remote").asText()).isEqualTo("127.0.0.1");
        assertThat(part.get("method").asText()).isEqualTo("GET");
        assertThat(part.get("path").asText()).isEqualTo(archivePath);
        assertThat(part.get("query").isNull()).isTrue();
        assertThat(part.get("protocol").asText()).isEqualTo("HTTP/1.1");
        assertThat(part.get("status").asInt()).isEqualTo(206);
        assertThat(part.get("bytes").asLong()).isEqualTo(100);
        assertThat(part.get("range").asText()).isEqualTo("bytes=0-99");
        assertThat(part.get("firstByteMillis").asDouble()).isPositive();
        assertThat(part.get("millis").asDouble())
                .isGreaterThanOrEqualTo(part.get("firstByteMillis").asDouble());
        assertThat(part.get("aborted").asBoolean()).isFalse();
        assertThat(lines.get(1).get("status").asInt()).isEqualTo(404);
        assertThat(lines.get(1).get("query").asText()).isEqualTo("a=b");
        assertThat(Files.readString(file)).matches("[\\x20-\\x7e\\n]*");
    }

    /** A full disk. */
    @Test
    void shouldGoOnLoggingWhenALineCouldNotBeWritten() throws Exception {
        ByteArrayOutputStream written = new ByteArrayOutputStream();
        AtomicBoolean full = new AtomicBoolean(true);
        try (AccessLog log = AccessLog.to(new FilterOutputStream(written) {
            @Override
            public void write(byte[] bytes) throws IOException {
                out.write(bytes, 0, full.get() ? 7 : bytes.length);
                if (full.get()) throw new IOException("no space left");
            }
        })) {
            start(ServerSettings.defaults(), log);
            get("/m/first/manifest.json");
            Await.until("a line that is lost", () -> log.lost() > 0);
            full.set(false);
            get("/m/second/manifest.json");
            stop();
        }
        String[] lines = written.toString(StandardCharsets.US_ASCII).split("\n");
        assertThat(lines).hasSize(2);
        assertThat(JSON.readTree(lines[1]).get("path").asText()).isEqualTo("/m/second/manifest.json");
    }

    @Test
    void shouldLogAnswersThatWereCut() throws Exception {
        Path file = logs.resolve("access.json");
        try (AccessLog log = AccessLog.to(file)) {
            start(ServerSettings.defaults(), log);
            try (Socket socket = connect()) {
                send(socket, requestLarge());
                assertThat(socket.getInputStream().readNBytes(1000)).hasSize(1000);
                socket.setSoLinger(true, 0);
            }
            Await.until("the connection's end", () -> server.metrics().text().contains("jsm_connections 0.0"));
            stop();
        }
        List<JsonNode> lines = lines(file);
        JsonNode last = lines.get(lines.size() - 1);
        assertThat(last.get("aborted").asBoolean()).isTrue();
        assertThat(last.get("bytes").asLong()).isLessThan(large.length);
    }

    @Test
    void shouldCountWhatItSends() throws Exception {
        get(archivePath, "Range", "bytes=0-99");
        get(archivePath, "Range", "bytes=0-199");
        String patches = archivePath.replace(".jsm", "/patches?from=0&bytesPerSecond=5000&waitMillis=1000");
        int planned = get(patches).body().length;
        get(archivePath.replace(".jsm", "/batches/0-0"));
        get("/m/");
        get("/");
        // An answer is counted after its last byte was sent.
        Await.until(
                "the page to be counted",
                () -> server.metrics().text().contains("jsm_requests_total{resource=\"page\",status=\"200\"} 1.0"));
        assertThat(server.metrics().text().lines())
                .contains(
                        "jsm_requests_total{resource=\"archive\",status=\"206\"} 2.0",
                        "jsm_requests_total{resource=\"patches\",status=\"200\"} 1.0",
                        "jsm_requests_total{resource=\"batches\",status=\"200\"} 1.0",
                        "jsm_requests_total{resource=\"catalogue\",status=\"200\"} 1.0",
                        "jsm_requests_total{resource=\"page\",status=\"200\"} 1.0",
                        "jsm_sent_bytes_total{resource=\"archive\"} 300.0",
                        "jsm_patches_planned_bytes_total " + (double) planned,
                        "jsm_patches_sent_bytes_total " + (double) planned,
                        "jsm_time_to_first_byte_seconds_count{resource=\"archive\"} 2",
                        "jsm_encode_queue_length 0.0",
                        "jsm_encode_running 0.0")
                .anyMatch(line -> line.startsWith("jvm_memory_used_bytes"))
                .anyMatch(line -> line.startsWith("jsm_connections "));
    }

    @Test
    void shouldLetTransfersEndBeforeItStops() throws Exception {
        start(ServerSettings.defaults().withGrace(PATIENCE_MILLIS));
        try (ManagementServer management = ManagementServer.start("127.0.0.1", 0, store(), server);
                Socket reader = connect();
                Socket idle = connect()) {
            URI ready = URI.create("http://127.0.0.1:" + management.port() + "/health/ready");
            assertThat(status(ready)).isEqualTo(200);
            send(idle, pipelined(1));
            idle.getInputStream().read();
            send(reader, requestLarge());
            assertThat(reader.getInputStream().readNBytes(1000)).hasSize(1000);
            URI address = server.uri();
            CompletableFuture<Void> stopped = CompletableFuture.runAsync(server::close);
            Await.until("the server to be no longer ready", () -> status(ready) == 503);
            Await.until("the server to accept no more", () -> !accepts(address));
            assertThat(stopped).as("it waits for the transfer").isNotDone();
            byte[] answer = readToEnd(reader);
            stopped.get(PATIENCE_MILLIS, TimeUnit.MILLISECONDS);
            byte[] end = Arrays.copyOfRange(answer, answer.length - large.length + 1000, answer.length);
            assertThat(Arrays.equals(end, Arrays.copyOfRange(large, 1000, large.length)))
                    .isTrue();
            readToEnd(idle);
        }
    }

    private static boolean accepts(URI uri) throws IOException {
        try (Socket socket = new Socket(uri.getHost(), uri.getPort())) {
            return socket.isConnected();
        } catch (ConnectException e) {
            return false;
        }
    }

    private static int status(URI uri) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(uri).build();
        return HttpClient.newHttpClient()
                .send(request, HttpResponse.BodyHandlers.discarding())
                .statusCode();
    }

    @Test
    void shouldCutTransfersThatOutlastTheGrace() throws Exception {
        start(ServerSettings.defaults().withGrace(300));
        try (Socket reader = connect()) {
            send(reader, requestLarge());
            assertThat(reader.getInputStream().readNBytes(1000)).hasSize(1000);
            server.close();
            assertThatThrownBy(() ->
                            new Socket(server.uri().getHost(), server.uri().getPort()))
                    .isInstanceOf(Exception.class);
        }
    }

    /** The command as a process of its own, told to end in the middle of a transfer. */
    @Test
    void shouldLetTransfersEndWhenTheProcessIsTold() throws Exception {
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        "-Xmx128m",
                        Jsm.class.getName(),
                        "serve",
                        folder.resolve("models").toString(),
                        "--port",
                        "0",
                        "--quiet",
                        "--access-log",
                        "-")
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        try (BufferedReader out = process.inputReader();
                Socket reader = new Socket()) {
            URI address = URI.create(out.readLine());
            reader.setReceiveBufferSize(8 << 10);
            reader.setSoTimeout(PATIENCE_MILLIS);
            reader.connect(new InetSocketAddress(address.getHost(), address.getPort()));
            send(reader, requestLarge());
            assertThat(reader.getInputStream().readNBytes(1000)).hasSize(1000);
            process.toHandle().destroy(); // SIGTERM; the process's own method would close its stdout for us
            Await.until("the server to accept no more", () -> !accepts(address));
            byte[] answer = readToEnd(reader);
            byte[] end = Arrays.copyOfRange(answer, answer.length - large.length + 1000, answer.length);
            assertThat(Arrays.equals(end, Arrays.copyOfRange(large, 1000, large.length)))
                    .isTrue();
            JsonNode line = JSON.readTree(out.readLine());
            assertThat(line.get("bytes").asLong()).isEqualTo(large.length);
            assertThat(line.get("aborted").asBoolean()).isFalse();
            assertThat(process.waitFor(PATIENCE_MILLIS, TimeUnit.MILLISECONDS)).isTrue();
            assertThat(process.exitValue()).isEqualTo(143);
        } finally {
            process.destroyForcibly();
        }
    }

    @Test
    void shouldStopThoughAnIdleClientOfHttp2Stays() throws Exception {
        int never = 600_000;
        Limits patient = Limits.defaults().withMillis(never, never, never, never);
        start(ServerSettings.defaults().withLimits(patient).withGrace(never));
        try (Socket socket = connect()) {
            byte[] block = HostileHttp2Test.request("/nothing");
            int flags = HostileHttp2Test.END_HEADERS | HostileHttp2Test.END_STREAM;
            socket.getOutputStream().write(HostileHttp2Test.PREFACE.getBytes(StandardCharsets.US_ASCII));
            socket.getOutputStream().write(HostileHttp2Test.frame(HostileHttp2Test.SETTINGS, 0, 0));
            socket.getOutputStream().write(HostileHttp2Test.frame(HostileHttp2Test.HEADERS, flags, 1, block));
            DataInputStream in = new DataInputStream(socket.getInputStream());
            int type;
            do {
                int header = in.readInt();
                type = header & 255;
                in.skipNBytes(5 + (header >>> 8));
            } while (type != HostileHttp2Test.HEADERS);
            server.close(); // fails the test by its timeout when it waits for the client
            assertThat(readToEnd(socket)).isNotEmpty();
        }
    }
}
