package org.jsmesh.app.server;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.app.Bumpy;
import org.jsmesh.app.Cli;
import org.jsmesh.app.TestKeystore;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(120)
class JsmServerTest {
    private static final byte SETTINGS_FRAME = 4;

    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    Path folder;

    @TempDir
    Path other;

    private ModelStore store;

    @BeforeEach
    void openStore() throws IOException {
        Files.writeString(folder.resolve("octahedron.off"), """
                OFF
                6 8 0
                1 0 0
                -1 0 0
                0 1 0
                0 -1 0
                0 0 1
                0 0 -1
                3 0 2 4
                3 2 1 4
                3 1 3 4
                3 3 0 4
                3 2 0 5
                3 1 2 5
                3 3 1 5
                3 0 3 5
                """);
        StoreSettings settings = StoreSettings.of(folder).withCache(other.resolve("cache"));
        store = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
    }

    @AfterEach
    void closeStore() {
        store.close();
    }

    @Test
    void shouldStreamAModelThatComesBackAsTheOriginal() throws Exception {
        try (JsmServer server = JsmServer.start(ServerSettings.defaults(), store)) {
            stream(server, HttpClient.newHttpClient(), HttpClient.Version.HTTP_1_1);
        }
    }

    private void stream(JsmServer server, HttpClient client, HttpClient.Version version) throws Exception {
        store.archive(store.find("octahedron").orElseThrow()).get();
        URI manifestUrl = server.uri().resolve("m/octahedron/manifest.json");
        HttpResponse<byte[]> manifestAnswer = get(client, manifestUrl);
        assertThat(manifestAnswer.version()).isEqualTo(version);
        JsonNode manifest = JSON.readTree(manifestAnswer.body());
        assertThat(manifest.get("faces").asInt()).isEqualTo(8);
        byte[] archive = get(
                        client, manifestUrl.resolve(manifest.get("archiveUrl").asText()))
                .body();
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, archive.length);
        assertThat(decoder.isComplete()).isTrue();
        String original = MeshIdentity.sha256(
                ModelFiles.read(folder.resolve("octahedron.off")).mesh());
        assertThat(MeshIdentity.sha256(decoder.mesh())).isEqualTo(original);
        assertThat(manifest.get("meshSha256").asText()).isEqualTo(original);
    }

    @ParameterizedTest
    @ValueSource(strings = {"/", "/m/octahedron/"})
    void shouldLetOthersFrameThePageWhereTheyMay(String path) throws Exception {
        ServerSettings settings = ServerSettings.defaults().withEmbedders(List.of("https://museum.example"));
        try (JsmServer server = JsmServer.start(settings, store)) {
            HttpResponse<byte[]> page =
                    get(HttpClient.newHttpClient(), server.uri().resolve(path), "Accept", "text/html");
            assertThat(page.statusCode()).isEqualTo(200);
            assertThat(page.headers().firstValue("Content-Security-Policy").orElseThrow())
                    .endsWith("; frame-ancestors 'self' https://museum.example");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"/", "/index.html"})
    void shouldServeThePage(String path) throws Exception {
        try (JsmServer server = JsmServer.start(ServerSettings.defaults(), store)) {
            HttpResponse<byte[]> page =
                    get(HttpClient.newHttpClient(), server.uri().resolve(path));
            assertThat(page.statusCode()).isEqualTo(200);
            assertThat(page.headers().firstValue("Content-Type").orElseThrow()).startsWith("text/html");
            assertThat(page.headers().firstValue("Content-Security-Policy").orElseThrow())
                    .contains("'wasm-unsafe-eval'");
            assertThat(page.headers().firstValue("Server")).isEmpty();
            assertThat(new String(page.body(), StandardCharsets.UTF_8)).contains("<title>jSM</title>");
        }
    }

    @Test
    void shouldServeScriptsCompressedAndValidated() throws Exception {
        try (JsmServer server = JsmServer.start(ServerSettings.defaults(), store)) {
            HttpClient client = HttpClient.newHttpClient();
            String page = new String(get(client, server.uri()).body(), StandardCharsets.UTF_8);
            Matcher name = Pattern.compile("src=\"(viewer/[^\"]+\\.js)\"").matcher(page);
            assertThat(name.find()).isTrue();
            URI script = server.uri().resolve(name.group(1));
            HttpResponse<byte[]> plain = get(client, script);
            assertThat(plain.headers().firstValue("Content-Type").orElseThrow()).startsWith("text/javascript");
            HttpResponse<byte[]> packed = get(client, script, "Accept-Encoding", "gzip");
            assertThat(packed.headers().firstValue("Content-Encoding")).contains("gzip");
            String tag = plain.headers().firstValue("ETag").orElseThrow();
            assertThat(get(client, script, "If-None-Match", tag).statusCode()).isEqualTo(304);
        }
    }

    @Test
    void shouldAnswerWhatJettyRefusesInShort() throws Exception {
        try (JsmServer server = JsmServer.start(ServerSettings.defaults(), store);
                Socket socket = new Socket("127.0.0.1", server.uri().getPort())) {
            String request = "GET /m/..%2f..%2fx HTTP/1.1\r\nHost: h\r\nAccept: text/html\r\nConnection: close\r\n\r\n";
            socket.getOutputStream().write(request.getBytes(StandardCharsets.ISO_8859_1));
            String answer = new String(socket.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
            assertThat(answer)
                    .startsWith("HTTP/1.1 400 ")
                    .contains("{\"error\":\"")
                    .doesNotContainIgnoringCase("jetty");
        }
    }

    @ParameterizedTest
    @EnumSource(HttpClient.Version.class)
    void shouldStreamWithTls(HttpClient.Version version) throws Exception {
        TestKeystore keystore = TestKeystore.in(other);
        ServerSettings settings = ServerSettings.defaults().withKeystore(keystore.file(), keystore.password());
        try (JsmServer server = JsmServer.start(settings, store)) {
            HttpClient client = HttpClient.newBuilder()
                    .sslContext(keystore.trusting())
                    .version(version)
                    .build();
            assertThat(server.uri().getScheme()).isEqualTo("https");
            stream(server, client, version);
        }
    }

    @Test
    void shouldStayWithHttp1WhenAnUpgradeIsOffered() throws Exception {
        try (JsmServer server = JsmServer.start(ServerSettings.defaults(), store)) {
            HttpResponse<byte[]> answer =
                    get(HttpClient.newHttpClient(), server.uri().resolve("m/"));
            assertThat(answer.statusCode()).isEqualTo(200);
            assertThat(answer.version()).isEqualTo(HttpClient.Version.HTTP_1_1);
        }
    }

    @Test
    void shouldSpeakHttp2WithAClientThatBeginsWithIt() throws Exception {
        try (JsmServer server = JsmServer.start(ServerSettings.defaults(), store);
                Socket socket = new Socket(server.uri().getHost(), server.uri().getPort())) {
            socket.setSoTimeout(10_000);
            byte[] noSettings = {0, 0, 0, SETTINGS_FRAME, 0, 0, 0, 0, 0};
            socket.getOutputStream().write("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
            socket.getOutputStream().write(noSettings);
            assertThat(socket.getInputStream().readNBytes(9)[3]).isEqualTo(SETTINGS_FRAME);
        }
    }

    @Test
    void shouldTellHowItIs() throws Exception {
        try (JsmServer server = JsmServer.start(ServerSettings.defaults(), store);
                ManagementServer management = ManagementServer.start("127.0.0.1", 0, store, server)) {
            HttpClient client = HttpClient.newHttpClient();
            get(client, server.uri().resolve("m/octahedron/manifest.json"));
            get(client, server.uri().resolve("m/nobody/manifest.json"));
            URI root = URI.create("http://127.0.0.1:" + management.port() + "/");
            assertThat(get(client, root.resolve("health/live")).statusCode()).isEqualTo(200);
            assertThat(get(client, root.resolve("health/ready")).statusCode()).isEqualTo(200);
            assertThat(get(client, root.resolve("m/")).statusCode()).isEqualTo(404);
            HttpRequest deletion = HttpRequest.newBuilder(root.resolve("metrics"))
                    .method("DELETE", HttpRequest.BodyPublishers.noBody())
                    .build();
            HttpResponse<String> refused = client.send(deletion, HttpResponse.BodyHandlers.ofString());
            assertThat(refused.statusCode()).isEqualTo(405);
            assertThat(refused.headers().firstValue("Allow")).contains("GET, HEAD");
            assertThat(JSON.readTree(refused.body()).get("remedy").asText()).isEqualTo("use GET or HEAD");
            String metrics = new String(get(client, root.resolve("metrics")).body(), StandardCharsets.UTF_8);
            assertThat(metrics.lines())
                    .contains(
                            "jsm_requests_total{resource=\"manifest\",status=\"404\"} 1.0",
                            "jsm_requests_total{resource=\"manifest\",status=\"200\"} 1.0",
                            "jsm_models{state=\"ready\"} 1.0",
                            "jsm_models{state=\"new\"} 0.0",
                            "jsm_encode_done_total 1.0");
            Files.delete(folder.resolve("octahedron.off"));
            Files.delete(folder);
            Await.until(
                    "the server to miss the folder",
                    () -> get(client, root.resolve("health/ready")).statusCode() == 503);
        }
    }

    @Test
    void shouldFetchTheOriginalByRangesAndByServerPlan() throws Exception {
        Bumpy.write(folder.resolve("bumpy.ply"), 150);
        assertThat(store.list()).hasSize(2);
        try (JsmServer server = JsmServer.start(ServerSettings.defaults(), store)) {
            URI manifest = server.uri().resolve("m/bumpy/manifest.json");
            Path byRanges = other.resolve("ranges.ply");
            assertThat(Cli.ok("fetch", manifest, "-o", byRanges, "--full").out())
                    .contains("the original");
            Path trace = other.resolve("trace.json");
            Path planned = other.resolve("planned.ply");
            Cli.ok(
                    "fetch",
                    manifest,
                    "-o",
                    planned,
                    "--server-plan",
                    "--rounds",
                    "50",
                    "--wait",
                    "1s",
                    "--trace",
                    trace);
            String original = MeshIdentity.sha256(
                    ModelFiles.read(folder.resolve("bumpy.ply")).mesh());
            assertThat(MeshIdentity.sha256(ModelFiles.read(byRanges).mesh())).isEqualTo(original);
            assertThat(MeshIdentity.sha256(ModelFiles.read(planned).mesh())).isEqualTo(original);
            assertThat(JSON.readTree(trace.toFile()).get("requests").findValuesAsText("url"))
                    .anyMatch(url -> url.contains("/patches?from="));
        }
    }

    private static HttpResponse<byte[]> get(HttpClient client, URI uri, String... headers) throws Exception {
        HttpRequest.Builder request = HttpRequest.newBuilder(uri);
        if (headers.length > 0) request.headers(headers);
        return client.send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
    }
}
