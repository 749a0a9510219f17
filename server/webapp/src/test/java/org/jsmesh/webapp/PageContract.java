package org.jsmesh.webapp;

import static org.assertj.core.api.Assertions.assertThat;

import jakarta.servlet.ServletContext;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jsmesh.servlet.ServletSettings;
import org.jsmesh.servlet.testing.RawHttp;
import org.jsmesh.servlet.testing.SlowReader;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.CountingEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.TestArchives;
import org.jsmesh.store.TestStores;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What every container has to answer to those who ask for the page. */
@Timeout(120)
abstract class PageContract {
    private static final int READERS = 40;

    @TempDir
    private Path folder;

    @TempDir
    private Path cache;

    private final HttpClient client =
            HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
    private ModelStore store;
    private TestServer server;

    abstract TestServer start(Consumer<ServletContext> application) throws Exception;

    @BeforeEach
    void startServer() throws Exception {
        Files.write(folder.resolve("Bunny.jsm"), TestArchives.of(7, 1000, 500));
        store = TestStores.open(folder, cache, new CountingEncoder());
        server = start(context -> StreamingApplication.install(context, store, ServletSettings.defaults()));
    }

    @AfterEach
    void stopServer() throws Exception {
        server.stop();
        store.close();
    }

    private HttpResponse<byte[]> get(String path, String... headers) throws Exception {
        HttpRequest.Builder request = HttpRequest.newBuilder(server.root().resolve(path));
        if (headers.length > 0) request.headers(headers);
        return client.send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
    }

    private static String header(HttpResponse<byte[]> answer, String name) {
        return answer.headers().firstValue(name).orElseThrow(() -> new AssertionError("no " + name));
    }

    @Test
    void shouldSendThePageAndItsFiles() throws Exception {
        HttpResponse<byte[]> page = get("");
        assertThat(page.statusCode()).isEqualTo(200);
        assertThat(new String(page.body(), StandardCharsets.UTF_8)).contains("viewer/app.js");
        assertThat(get("?m=bunny").body()).isEqualTo(page.body());
        assertThat(get("index.html").body()).isEqualTo(page.body());
        HttpResponse<byte[]> script = get("viewer/app.js");
        assertThat(script.statusCode()).isEqualTo(200);
        assertThat(header(script, "Content-Type")).startsWith("text/javascript");
        assertThat(get("viewer/app.js", "If-None-Match", header(script, "ETag")).statusCode())
                .isEqualTo(304);
    }

    @Test
    void shouldSendPeopleFromTheCatalogueToThePage() throws Exception {
        HttpResponse<byte[]> answer = get("m/", "Accept", "text/html,application/xhtml+xml,*/*;q=0.8");
        assertThat(answer.statusCode()).isEqualTo(303);
        assertThat(answer.uri().resolve(header(answer, "Location"))).isEqualTo(server.root());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "viewer/app.js", "nothing.html"})
    void shouldGuardThePage(String path) throws Exception {
        HttpResponse<byte[]> answer = get(path);
        assertThat(answer.statusCode()).isEqualTo(path.startsWith("nothing") ? 404 : 200);
        assertThat(header(answer, "X-Content-Type-Options")).isEqualTo("nosniff");
        assertThat(header(answer, "Cross-Origin-Opener-Policy")).isEqualTo("same-origin");
        assertThat(header(answer, "Permissions-Policy")).contains("camera=()");
        assertThat(header(answer, "Content-Security-Policy"))
                .contains("default-src 'none'", "'wasm-unsafe-eval'")
                .doesNotContain("'unsafe-eval'")
                .doesNotContain("unsafe-inline");
    }

    @ParameterizedTest
    @ValueSource(strings = {"m/", "m/bunny/manifest.json", "m/nobody/manifest.json"})
    void shouldGiveDataNoHeadersOfAPage(String path) throws Exception {
        HttpResponse<byte[]> answer = get(path);
        assertThat(header(answer, "Content-Security-Policy")).doesNotContain("script-src");
        assertThat(answer.headers().map()).doesNotContainKeys("cross-origin-opener-policy", "permissions-policy");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "/META-INF/MANIFEST.MF",
                "/META-INF/resources/jsm/index.html",
                "/jsm/index.html",
                "/WEB-INF/web.xml",
                "/viewer/",
                "/org/jsmesh/webapp/PageServlet.class",
                "/../META-INF/MANIFEST.MF",
                "/../webjars/x.js",
                "/%2e%2e/maven/x.json"
            })
    void shouldNotFollowHostilePaths(String target) throws Exception {
        assertThat(RawHttp.get(server.root(), target))
                .matches("(?s)HTTP/1\\.1 (400|404) .*")
                .doesNotContain("\tat ")
                .doesNotContain("Exception");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "nothing.html"})
    void shouldRefuseOtherMethods(String path) throws Exception {
        for (String method : List.of("POST", "PUT", "DELETE", "PATCH")) {
            HttpRequest request = HttpRequest.newBuilder(server.root().resolve(path))
                    .method(method, HttpRequest.BodyPublishers.ofString("x"))
                    .build();
            HttpResponse<byte[]> answer = client.send(request, HttpResponse.BodyHandlers.ofByteArray());
            assertThat(answer.statusCode()).isEqualTo(405);
            assertThat(header(answer, "Allow")).isEqualTo("GET, HEAD, OPTIONS");
            assertThat(new String(answer.body(), StandardCharsets.UTF_8)).contains("\"remedy\"");
        }
    }

    /** The server has fewer threads than there are readers, and a few files are less than the kernel takes. */
    @Tag("slow")
    @Test
    void shouldHoldNoThreadForSlowReaders() throws Exception {
        String path = "viewer/three/three.core.min.js";
        int length = get(path).body().length;
        int times = 16_000_000 / length;
        List<SlowReader> readers = new ArrayList<>();
        try {
            for (int i = 0; i < READERS; i++) readers.add(new SlowReader(server.root(), path, times));
            for (SlowReader reader : readers) assertThat(reader.header()).startsWith("HTTP/1.1 200");
            assertThat(get("m/").statusCode()).as("others are served meanwhile").isEqualTo(200);
            for (SlowReader reader : readers) assertThat(reader.body().length).isGreaterThan(times * length);
        } finally {
            for (SlowReader reader : readers) reader.close();
        }
    }
}
