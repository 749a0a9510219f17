package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.store.CountingEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.TestArchives;
import org.jsmesh.store.TestStores;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(60)
class AnnotationsTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    @TempDir
    private Path cache;

    @Test
    void shouldSendWhatStandsBesideTheModel() throws Exception {
        Files.write(folder.resolve("bunny.jsm"), TestArchives.of(7, 1000, 500, 2000));
        try (ModelStore store = TestStores.open(folder, cache, new CountingEncoder())) {
            JettyServer server = new JettyServer(
                    application -> new StreamingServlet(store, ServletSettings.defaults()).mount(application, "/*"));
            try {
                HttpClient client = HttpClient.newHttpClient();
                HttpRequest request = HttpRequest.newBuilder(server.root().resolve("bunny/annotations.json"))
                        .build();
                HttpRequest manifest = HttpRequest.newBuilder(server.root().resolve("bunny/manifest.json"))
                        .build();
                assertThat(client.send(request, HttpResponse.BodyHandlers.ofString())
                                .statusCode())
                        .isEqualTo(404);
                assertThat(json(client, manifest).has("annotationsUrl")).isFalse();

                String text = "{\"annotations\": [{\"title\": \"Ear\", \"point\": [1, 2, 3]}]}";
                Path file = Files.writeString(folder.resolve("bunny.annotations.json"), text);
                assertThat(json(client, manifest).get("annotationsUrl").asText())
                        .isEqualTo("annotations.json");
                HttpResponse<String> answer = client.send(request, HttpResponse.BodyHandlers.ofString());
                assertThat(answer.statusCode()).isEqualTo(200);
                assertThat(answer.body()).isEqualTo(text);
                assertThat(answer.headers().firstValue("Content-Type")).contains("application/json");

                Files.writeString(file, "{");
                answer = client.send(request, HttpResponse.BodyHandlers.ofString());
                assertThat(answer.statusCode()).isEqualTo(422);
                assertThat(JSON.readTree(answer.body()).get("error").asText()).contains("is not JSON in line 1");
            } finally {
                server.stop();
            }
        }
    }

    private static JsonNode json(HttpClient client, HttpRequest request) throws Exception {
        return JSON.readTree(
                client.send(request, HttpResponse.BodyHandlers.ofString()).body());
    }
}
