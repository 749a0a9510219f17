package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.servlet.http.Digests;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.CountingEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.TestArchives;
import org.jsmesh.store.TestStores;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A server with one archive, and what it takes to ask it over real connections. */
@Timeout(120)
abstract class ContractServer {
    /** Ends of the batches: 1000, 1500, 3500, 6500, 10500. */
    static final byte[] ARCHIVE = TestArchives.of(7, 1000, 500, 2000, 3000, 4000);

    static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    Path folder;

    @TempDir
    Path cache;

    final HttpClient client =
            HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
    final CountingEncoder encoder = new CountingEncoder();
    ModelStore store;
    TestServer server;
    String sha256;

    abstract TestServer start(ModelStore store) throws Exception;

    @BeforeEach
    void startServer() throws Exception {
        Files.write(folder.resolve("Bunny.jsm"), ARCHIVE);
        store = TestStores.open(folder, cache, encoder);
        server = start(store);
        sha256 = Digests.sha256(ARCHIVE);
    }

    @AfterEach
    void stopServer() throws Exception {
        encoder.release();
        server.stop();
        store.close();
    }

    String archiveUrl() {
        return "m/bunny/" + sha256 + ".jsm";
    }

    final HttpResponse<byte[]> get(String path, String... headers) throws IOException, InterruptedException {
        return client.send(request(path, headers).build(), HttpResponse.BodyHandlers.ofByteArray());
    }

    /** Asks as long as the server prepares the answer. */
    final HttpResponse<byte[]> whenReady(String path) throws Exception {
        List<HttpResponse<byte[]>> last = new ArrayList<>();
        Await.until("an answer to " + path, () -> {
            last.add(get(path));
            return last.get(last.size() - 1).statusCode() != 202;
        });
        return last.get(last.size() - 1);
    }

    final HttpRequest.Builder request(String path, String... headers) {
        HttpRequest.Builder request = HttpRequest.newBuilder(server.root().resolve(path));
        return headers.length == 0 ? request : request.headers(headers);
    }

    URI location(String path, HttpResponse<byte[]> answer) {
        return server.root().resolve(path).resolve(header(answer, "Location"));
    }

    static String header(HttpResponse<byte[]> answer, String name) {
        return answer.headers().firstValue(name).orElseThrow(() -> new AssertionError("no " + name));
    }

    static JsonNode assertError(HttpResponse<byte[]> answer) throws IOException {
        JsonNode error = JSON.readTree(answer.body());
        assertThat(error.get("error").asText()).isNotBlank();
        assertThat(error.get("remedy").asText()).isNotBlank();
        assertThat(header(answer, "Cache-Control")).isEqualTo("no-store");
        return error;
    }
}
