package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import jakarta.servlet.ServletContext;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Arrays;
import java.util.function.Consumer;
import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.servlet.testing.TomcatServer;
import org.jsmesh.store.CountingEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.TestArchives;
import org.jsmesh.store.TestStores;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Models that have a whole application but for the pages that other servlets answer. */
@Timeout(60)
class RootPlaceTest {
    private static final byte[] ARCHIVE = TestArchives.of(7, 1000, 500, 2000);
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    @TempDir
    private Path cache;

    private final HttpClient client = HttpClient.newHttpClient();
    private ModelStore store;
    private TestServer server;

    @BeforeEach
    void open() throws Exception {
        Files.write(folder.resolve("bunny.jsm"), ARCHIVE);
        store = TestStores.open(folder, cache, new CountingEncoder());
    }

    @AfterEach
    void stop() throws Exception {
        if (server != null) server.stop();
        store.close();
    }

    @ParameterizedTest
    @CsvSource({"jetty, /", "jetty, /*", "tomcat, /", "tomcat, /*"})
    void shouldServeModelsAtTheRoot(String container, String pattern) throws Exception {
        Consumer<ServletContext> application = context -> {
            context.addServlet("about", new AboutPage()).addMapping("/about");
            new StreamingServlet(store, ServletSettings.defaults()).mount(context, pattern);
        };
        server = container.equals("jetty") ? new JettyServer(application) : new TomcatServer(application);
        assertThat(text(get("about"))).isEqualTo(HostContract.ABOUT);
        assertThat(JSON.readTree(get("").body()).get("models")).hasSize(1);
        JsonNode row = JSON.readTree(get("index.json").body()).at("/models/0");
        Instant modified =
                Files.getLastModifiedTime(folder.resolve("bunny.jsm")).toInstant();
        assertThat(row.get("modified").asText())
                .isEqualTo(modified.truncatedTo(ChronoUnit.SECONDS).toString());
        HttpResponse<byte[]> manifest = get(row.get("manifestUrl").asText());
        URI archive = manifest.uri()
                .resolve(JSON.readTree(manifest.body()).get("archiveUrl").asText());
        assertThat(get(archive.getPath().substring(1)).body()).isEqualTo(ARCHIVE);
        String hash = JSON.readTree(manifest.body()).get("archiveSha256").asText();
        assertThat(get("bunny/" + hash + "/batches/1-1").body()).isEqualTo(Arrays.copyOfRange(ARCHIVE, 1000, 1500));
        assertThat(get("bunny/" + hash + "/patches?from=2&bytesPerSecond=1&waitMillis=1")
                        .body())
                .isEqualTo(Arrays.copyOfRange(ARCHIVE, 1500, 3500));
        assertThat(get("nowhere").statusCode()).isEqualTo(404);
        assertThat(text(get("nowhere"))).contains("there is no such model or resource");
    }

    private static String text(HttpResponse<byte[]> answer) {
        return new String(answer.body(), StandardCharsets.UTF_8);
    }

    private HttpResponse<byte[]> get(String path) throws Exception {
        HttpRequest request =
                HttpRequest.newBuilder(server.root().resolve(path)).build();
        return client.send(request, HttpResponse.BodyHandlers.ofByteArray());
    }
}
