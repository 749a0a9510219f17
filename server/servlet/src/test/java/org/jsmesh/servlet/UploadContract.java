package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.Stream;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.upload.UploadSettings;
import org.jsmesh.upload.UploadTokens;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What every container has to answer to clients that send models, with processes that encode them. */
@Timeout(180)
abstract class UploadContract {
    private static final String TOKEN = "0123456789abcdef0123456789abcdef";
    private static final String CHAIRS = "fedcba9876543210fedcba9876543210";
    private static final int MOST_BYTES = 200_000;
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    private final HttpClient client =
            HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
    private UploadSettings settings;
    private Path models;
    private ModelStore store;
    private TestServer server;

    abstract TestServer start(ModelStore withUploads) throws Exception;

    @BeforeEach
    void begin() throws Exception {
        models = Files.createDirectory(folder.resolve("models"));
        Files.writeString(models.resolve("stool.ply"), ply(4));
        Path tokens = Files.writeString(folder.resolve("tokens"), TOKEN + "\n" + CHAIRS + " chair\n");
        settings = UploadSettings.of(UploadTokens.read(tokens))
                .withMostBytes(MOST_BYTES)
                .withMostFaces(5000)
                .withQueued(2)
                .withHeapMegabytes(48);
    }

    @AfterEach
    void end() throws Exception {
        if (server != null) server.stop();
        if (store != null) store.close();
    }

    private void open() throws Exception {
        store = new ModelStore(
                StoreSettings.of(models).withCache(folder.resolve("cache")),
                new ModelFilesEncoder(EncoderSettings.defaults()));
        store.acceptUploads(settings);
        server = start(store);
    }

    /** A bumpy grid. */
    private static String ply(int size) {
        StringBuilder text = new StringBuilder("ply\nformat ascii 1.0\nelement vertex " + size * size
                + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + 2 * (size - 1) * (size - 1)
                + "\nproperty list uchar int vertex_indices\nend_header\n");
        for (int i = 0; i < size * size; i++) {
            text.append(String.format(Locale.ROOT, "%d %d %.3f%n", i % size, i / size, Math.sin(i * .7)));
        }
        for (int y = 0; y < size - 1; y++) {
            for (int x = 0; x < size - 1; x++) {
                int a = y * size + x;
                text.append("3 " + a + " " + (a + 1) + " " + (a + size + 1) + "\n");
                text.append("3 " + a + " " + (a + size + 1) + " " + (a + size) + "\n");
            }
        }
        return text.toString();
    }

    private HttpRequest.Builder post(String path) {
        return HttpRequest.newBuilder(server.root().resolve(path)).header("Authorization", "Bearer " + TOKEN);
    }

    private HttpResponse<byte[]> send(HttpRequest.Builder request, String body) throws Exception {
        return client.send(
                request.POST(HttpRequest.BodyPublishers.ofString(body)).build(),
                HttpResponse.BodyHandlers.ofByteArray());
    }

    private HttpResponse<byte[]> get(URI address) throws Exception {
        return client.send(HttpRequest.newBuilder(address).build(), HttpResponse.BodyHandlers.ofByteArray());
    }

    private JsonNode await(HttpResponse<byte[]> accepted) throws Exception {
        assertThat(accepted.statusCode())
                .as(new String(accepted.body(), StandardCharsets.UTF_8))
                .isEqualTo(202);
        URI address =
                accepted.uri().resolve(accepted.headers().firstValue("Location").orElseThrow());
        while (true) {
            HttpResponse<byte[]> answer = get(address);
            assertThat(answer.statusCode()).isEqualTo(200);
            assertThat(answer.headers().firstValue("Cache-Control")).contains("no-store");
            JsonNode status = JSON.readTree(answer.body());
            if (!status.get("state").asText().matches("queued|encoding")) return status;
            assertThat(answer.headers().firstValue("Retry-After")).isPresent();
            Thread.sleep(20);
        }
    }

    private void assertRefused(HttpResponse<byte[]> answer, int status, String words) throws IOException {
        assertThat(answer.statusCode()).isEqualTo(status);
        JsonNode body = JSON.readTree(answer.body());
        assertThat(body.get("error").asText()).contains(words);
        assertThat(body.get("remedy").asText()).isNotEmpty();
        assertNothingIsLeft();
    }

    private void assertNothingIsLeft() throws IOException {
        try (Stream<Path> files = Files.list(models.resolve("uploads/.spool"))) {
            assertThat(files).isEmpty();
        }
    }

    @Test
    void shouldEncodeWhatIsSentAndServeIt() throws Exception {
        open();
        JsonNode status = await(send(post("m/bench").header("Content-Type", "model/ply"), ply(30)));
        assertThat(status.get("state").asText()).as(status.toString()).isEqualTo("ready");
        URI manifest =
                server.root().resolve("m/bench/" + status.get("manifestUrl").asText());
        JsonNode described = JSON.readTree(get(manifest).body());
        assertThat(described.get("name").asText()).isEqualTo("bench");
        byte[] archive =
                get(manifest.resolve(described.get("archiveUrl").asText())).body();
        Path original = Files.writeString(folder.resolve("original.ply"), ply(30));
        assertThat(MeshIdentity.sha256(ArchiveFile.of(archive).original(ProgressListener.NONE)))
                .isEqualTo(MeshIdentity.sha256(
                        org.jsmesh.files.ModelFiles.read(original).mesh()));
        assertNothingIsLeft();
        // Sent again it is replaced, and who holds the old one learns of it.
        await(send(post("m/bench?name=bench.ply"), ply(20)));
        assertThat(get(manifest.resolve(described.get("archiveUrl").asText())).statusCode())
                .isEqualTo(404);
        assertThat(JSON.readTree(get(manifest).body()).get("faces").asInt()).isEqualTo(2 * 19 * 19);
    }

    @Test
    void shouldTakeBodiesWithoutALength() throws Exception {
        open();
        HttpRequest.BodyPublisher chunked = HttpRequest.BodyPublishers.ofInputStream(
                () -> new ByteArrayInputStream(ply(10).getBytes(StandardCharsets.UTF_8)));
        HttpRequest request = post("m/bench").POST(chunked).build();
        JsonNode status = await(client.send(request, HttpResponse.BodyHandlers.ofByteArray()));
        assertThat(status.get("state").asText()).as(status.toString()).isEqualTo("ready");
    }

    @Test
    void shouldAskWhoSends() throws Exception {
        open();
        HttpRequest.Builder nobody = HttpRequest.newBuilder(server.root().resolve("m/bench"));
        HttpResponse<byte[]> answer = send(nobody, ply(4));
        assertRefused(answer, 401, "token");
        assertThat(answer.headers().firstValue("WWW-Authenticate")).contains("Bearer");
        answer = send(post("m/bench").setHeader("Authorization", "Bearer " + TOKEN + "0"), ply(4));
        assertRefused(answer, 401, "token");
        assertThat(answer.headers().firstValue("WWW-Authenticate").orElse("")).contains("invalid_token");
        assertRefused(send(post("m/bench").setHeader("Authorization", "Basic " + TOKEN), ply(4)), 401, "token");
        assertRefused(send(post("m/bench").setHeader("Authorization", "Bearer " + CHAIRS), ply(4)), 403, "bench");
        JsonNode chair = await(send(post("m/chair-1").setHeader("Authorization", "Bearer " + CHAIRS), ply(4)));
        assertThat(chair.get("state").asText()).isEqualTo("ready");
    }

    @ParameterizedTest
    @CsvSource({"a--b, 400", "-a, 400", "a-, 400", "stool, 409"})
    void shouldRefuseIds(String id, int status) throws Exception {
        open();
        assertRefused(send(post("m/" + id), ply(4)), status, id);
    }

    @Test
    void shouldNotTakeModelsThatWouldNotGetTheirId() throws Exception {
        for (String name : new String[] {"a", "b"})
            Files.writeString(Files.createDirectory(models.resolve(name)).resolve("bunny.ply"), ply(4));
        open();
        assertRefused(send(post("m/bunny"), ply(4)), 409, "bunny");
    }

    @Test
    void shouldTellWhereTheModelIsWhenFilesHaveComeInItsWay() throws Exception {
        open();
        HttpResponse<byte[]> accepted = send(post("m/bench"), ply(5));
        assertThat(await(accepted).get("manifestUrl").asText()).isEqualTo("manifest.json");
        Files.writeString(models.resolve("bench.ply"), ply(4));
        get(server.root().resolve("m/index.json"));
        JsonNode status = await(accepted);
        URI manifest =
                server.root().resolve("m/bench/" + status.get("manifestUrl").asText());
        assertThat(JSON.readTree(get(manifest).body()).get("faces").asInt()).isEqualTo(2 * 4 * 4);
    }

    @ParameterizedTest
    @CsvSource({"m/, 405", "m/Bench, 405", "m/bench/manifest.json, 405", "m/a/b/c, 405", "m/..%2fx, 400"})
    void shouldTakeModelsNowhereElse(String path, int status) throws Exception {
        open();
        assertThat(send(post(path), ply(4)).statusCode()).isIn(status, 400);
        assertNothingIsLeft();
    }

    @Test
    void shouldRefuseWhatIsNoModel() throws Exception {
        open();
        assertRefused(send(post("m/bench").header("Content-Type", "text/html"), "<p>"), 415, "no model");
        assertRefused(send(post("m/bench?name=x.exe"), "MZ"), 415, "no model");
        assertRefused(
                send(post("m/bench").header("Content-Disposition", "attachment; filename=\"x.php\""), "<?"),
                415,
                "no model");
        assertRefused(send(post("m/bench"), ""), 422, "empty");
        JsonNode status = await(send(post("m/bench").header("Content-Type", "model/ply"), "ply\nnonsense\n"));
        assertThat(status.get("state").asText()).isEqualTo("failed");
        assertThat(status.get("error").asText()).contains("cannot be read");
        assertThat(status.get("remedy").asText()).isNotEmpty();
        assertThat(status.toString()).doesNotContain(folder.toString());
        assertThat(get(server.root().resolve("m/bench/manifest.json")).statusCode())
                .isEqualTo(404);
    }

    @Test
    void shouldRefuseWhatIsTooLarge() throws Exception {
        open();
        String head = "POST /m/bench HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer " + TOKEN + "\r\n";
        // Nothing of the body is waited for.
        assertThat(raw(head + "Content-Length: 99999999999\r\n\r\n")).startsWith("HTTP/1.1 413 ");
        assertThat(raw(head + "\r\n")).startsWith("HTTP/1.1 411 ");
        StringBuilder chunks = new StringBuilder(head + "Transfer-Encoding: chunked\r\n\r\n");
        for (int i = 0; i < 30; i++)
            chunks.append("2000\r\n").append("x".repeat(0x2000)).append("\r\n");
        assertThat(raw(chunks.toString())).startsWith("HTTP/1.1 413 ");
        assertNothingIsLeft();
        JsonNode status = await(send(post("m/bench"), ply(60)));
        assertThat(status.get("error").asText()).contains("6962 faces", "5000");
    }

    /** Sends all, and reads until the server closes or an answer has come. */
    private String raw(String request) throws IOException {
        try (Socket socket = new Socket("127.0.0.1", server.root().getPort())) {
            socket.setSoTimeout(10_000);
            OutputStream out = socket.getOutputStream();
            out.write(request.getBytes(StandardCharsets.ISO_8859_1));
            out.flush();
            byte[] head = new byte[64];
            InputStream in = socket.getInputStream();
            int count = in.read(head);
            return count < 0 ? "" : new String(head, 0, count, StandardCharsets.ISO_8859_1);
        }
    }

    @Test
    void shouldForgetABodyThatEndsEarly() throws Exception {
        open();
        try (Socket socket = new Socket("127.0.0.1", server.root().getPort())) {
            String text = ply(10);
            String head = "POST /m/bench HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer " + TOKEN + "\r\nContent-Length: "
                    + text.length() + "\r\n\r\n";
            socket.getOutputStream().write((head + text.substring(0, 1000)).getBytes(StandardCharsets.ISO_8859_1));
            socket.getOutputStream().flush();
            while (store.uploads().length() == 0) Thread.sleep(2);
        }
        while (store.uploads().length() > 0) Thread.sleep(2);
        assertNothingIsLeft();
        assertThat(get(server.root().resolve("m/bench/status")).statusCode()).isEqualTo(404);
    }

    @Test
    void shouldSayThatTheQueueIsFull() throws Exception {
        open();
        try (Socket first = new Socket("127.0.0.1", server.root().getPort());
                Socket second = new Socket("127.0.0.1", server.root().getPort())) {
            for (Socket socket : new Socket[] {first, second}) {
                String head = "POST /m/slow HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer " + TOKEN
                        + "\r\nContent-Length: 1000\r\n\r\nx";
                socket.getOutputStream().write(head.getBytes(StandardCharsets.ISO_8859_1));
                socket.getOutputStream().flush();
            }
            while (store.uploads().length() < 2) Thread.sleep(2);
            HttpResponse<byte[]> answer = send(post("m/bench"), ply(4));
            assertThat(answer.statusCode()).isEqualTo(429);
            assertThat(answer.headers().firstValue("Retry-After").orElse("")).matches("[1-9]\\d*");
        }
        while (store.uploads().length() > 0) Thread.sleep(2);
        assertThat(await(send(post("m/bench"), ply(4))).get("state").asText()).isEqualTo("ready");
    }

    @Test
    void shouldSurviveHostileFiles() throws Exception {
        settings = settings.withEncodeMillis(20_000);
        open();
        String[] hostile = {
            // More vertices than there is memory for, and more than there are bytes.
            "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n" + "1\n".repeat(90_000),
            "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + "[".repeat(90_000) + "}",
            "OFF\n3 1000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
            "\0".repeat(MOST_BYTES)
        };
        String[] names = {"x.ply", "x.ply", "x.gltf", "x.off", "x.stl"};
        for (int i = 0; i < hostile.length; i++) {
            JsonNode status = await(send(post("m/bad-" + i + "?name=" + names[i]), hostile[i]));
            assertThat(status.get("state").asText()).as(names[i] + " " + i).isEqualTo("failed");
            assertThat(status.get("error").asText()).isNotEmpty().doesNotContain("Exception", folder.toString());
            assertThat(get(server.root().resolve("m/stool/manifest.json")).statusCode())
                    .isEqualTo(200);
        }
        assertNothingIsLeft();
        assertThat(models.resolve("uploads")).isDirectoryNotContaining("glob:**.jsm");
    }

    @Test
    void shouldEndWhatTakesTooLong() throws Exception {
        settings = settings.withEncodeMillis(1);
        open();
        JsonNode status = await(send(post("m/bench"), ply(30)));
        assertThat(status.get("error").asText()).contains("took longer");
        assertNothingIsLeft();
        assertThat(models.resolve("uploads/bench.jsm")).doesNotExist();
    }
}
