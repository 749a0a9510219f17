package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.test.Await;
import org.jsmesh.upload.UploadSettings;
import org.jsmesh.upload.UploadTokens;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A server that takes models, with processes that encode them. */
@Timeout(180)
abstract class UploadFixture {
    static final String TOKEN = "0123456789abcdef0123456789abcdef";
    static final String CHAIRS = "fedcba9876543210fedcba9876543210";
    static final int MOST_BYTES = 200_000;
    static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    Path folder;

    final HttpClient client =
            HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
    UploadSettings settings;
    Path models;
    ModelStore store;
    TestServer server;

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

    void open() throws Exception {
        store = new ModelStore(
                StoreSettings.of(models).withCache(folder.resolve("cache")),
                new ModelFilesEncoder(EncoderSettings.defaults()));
        store.acceptUploads(settings);
        server = start(store);
    }

    /** A bumpy grid. */
    static String ply(int size) {
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

    HttpRequest.Builder post(String path) {
        return HttpRequest.newBuilder(server.root().resolve(path)).header("Authorization", "Bearer " + TOKEN);
    }

    HttpResponse<byte[]> send(HttpRequest.Builder request, String body) throws Exception {
        return client.send(
                request.POST(HttpRequest.BodyPublishers.ofString(body)).build(),
                HttpResponse.BodyHandlers.ofByteArray());
    }

    HttpResponse<byte[]> get(URI address) throws Exception {
        return client.send(HttpRequest.newBuilder(address).build(), HttpResponse.BodyHandlers.ofByteArray());
    }

    JsonNode await(HttpResponse<byte[]> accepted) throws Exception {
        assertThat(accepted.statusCode())
                .as(new String(accepted.body(), StandardCharsets.UTF_8))
                .isEqualTo(202);
        URI address =
                accepted.uri().resolve(accepted.headers().firstValue("Location").orElseThrow());
        AtomicReference<JsonNode> last = new AtomicReference<>();
        Await.until("the end of " + address, () -> {
            HttpResponse<byte[]> answer = get(address);
            assertThat(answer.statusCode()).isEqualTo(200);
            assertThat(answer.headers().firstValue("Cache-Control")).contains("no-store");
            JsonNode status = JSON.readTree(answer.body());
            last.set(status);
            if (!status.get("state").asText().matches("queued|encoding")) return true;
            assertThat(answer.headers().firstValue("Retry-After")).isPresent();
            return false;
        });
        return last.get();
    }

    void assertRefused(HttpResponse<byte[]> answer, int status, String words) throws IOException {
        assertThat(answer.statusCode()).isEqualTo(status);
        JsonNode body = JSON.readTree(answer.body());
        assertThat(body.get("error").asText()).contains(words);
        assertThat(body.get("remedy").asText()).isNotEmpty();
        assertNothingIsLeft();
    }

    void assertNothingIsLeft() throws IOException {
        try (Stream<Path> files = Files.list(models.resolve("uploads/.spool"))) {
            assertThat(files).isEmpty();
        }
    }
}
