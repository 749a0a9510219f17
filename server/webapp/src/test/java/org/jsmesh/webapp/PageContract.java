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
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.servlet.ServletSettings;
import org.jsmesh.servlet.testing.RawHttp;
import org.jsmesh.servlet.testing.SlowReader;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.CountingEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.TestArchives;
import org.jsmesh.store.TestStores;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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
        String script = PageNames.script(page.body());
        assertThat(get("?m=bunny").body()).isEqualTo(page.body());
        assertThat(get("index.html").body()).isEqualTo(page.body());
        HttpResponse<byte[]> answer = get(script);
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(header(answer, "Content-Type")).startsWith("text/javascript");
        assertThat(get(script, "If-None-Match", header(answer, "ETag")).statusCode())
                .isEqualTo(304);
    }

    /** As a browser with and one without TLS ask, and as a program that is particular. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "gzip, deflate, br, zstd|br",
                "gzip, deflate|gzip",
                "br;q=0.5, gzip;q=0.6|gzip",
                "br;q=0, gzip;q=0|''",
                "identity, br;q=0.9|''",
                "zstd|''"
            })
    void shouldSendFilesAsTheyWerePackedWhenThePageWasBuilt(String accepted, String coding) throws Exception {
        for (String path : List.of(PageNames.script(get("").body()), "index.html")) {
            if (coding.equals("br") && !PageNames.exists(path + ".br")) {
                Assumptions.abort("the page was built without Brotli, which this machine lacks");
            }
            HttpResponse<byte[]> plain = get(path);
            HttpResponse<byte[]> answer = get(path, "Accept-Encoding", accepted);
            assertThat(answer.statusCode()).isEqualTo(200);
            assertThat(answer.headers().firstValue("Content-Encoding").orElse(""))
                    .isEqualTo(coding);
            assertThat(answer.body()).isEqualTo(PageNames.file(path + suffix(coding)));
            assertThat(header(answer, "Content-Length")).isEqualTo("" + answer.body().length);
            assertThat(header(answer, "Content-Type")).isEqualTo(header(plain, "Content-Type"));
            assertThat(header(answer, "Vary")).isEqualTo("Accept-Encoding");
            String tag = header(answer, "ETag");
            assertThat(tag).startsWith("\"").endsWith(coding.isEmpty() ? "\"" : "-" + coding + "\"");
            assertThat(tag.equals(header(plain, "ETag"))).isEqualTo(coding.isEmpty());
            HttpResponse<byte[]> again = get(path, "Accept-Encoding", accepted, "If-None-Match", tag);
            assertThat(again.statusCode()).isEqualTo(304);
            assertThat(header(again, "Vary")).isEqualTo("Accept-Encoding");
            assertThat(header(again, "Cache-Control")).isEqualTo(header(answer, "Cache-Control"));
        }
    }

    private static String suffix(String coding) {
        return coding.isEmpty() ? "" : coding.equals("br") ? ".br" : ".gz";
    }

    @Test
    void shouldLetFilesBeKeptThatAreNamedAfterTheirContent() throws Exception {
        for (String path : List.of(PageNames.script(get("").body()), PageNames.largest(".svg"))) {
            assertThat(header(get(path), "Cache-Control")).isEqualTo("public, max-age=31536000, immutable");
        }
        for (String path : List.of("", "index.html", "viewer/three-LICENSE.txt")) {
            assertThat(header(get(path), "Cache-Control")).isEqualTo("no-cache");
        }
        assertThat(get(PageNames.largest(".js") + ".gz").statusCode()).isEqualTo(404);
    }

    @Test
    void shouldSendTheSameHeadersWithoutABody() throws Exception {
        String path = PageNames.largest(".js");
        HttpRequest request = HttpRequest.newBuilder(server.root().resolve(path))
                .method("HEAD", HttpRequest.BodyPublishers.noBody())
                .header("Accept-Encoding", "gzip")
                .build();
        HttpResponse<byte[]> head = client.send(request, HttpResponse.BodyHandlers.ofByteArray());
        HttpResponse<byte[]> whole = get(path, "Accept-Encoding", "gzip");
        for (String name : List.of("Content-Length", "Content-Encoding", "Content-Type", "ETag", "Cache-Control")) {
            assertThat(header(head, name)).as(name).isEqualTo(header(whole, name));
        }
        assertThat(head.body()).isEmpty();
    }

    @Test
    void shouldSendPeopleFromTheCatalogueToThePage() throws Exception {
        HttpResponse<byte[]> answer = get("m/", "Accept", "text/html,application/xhtml+xml,*/*;q=0.8");
        assertThat(answer.statusCode()).isEqualTo(303);
        assertThat(answer.uri().resolve(header(answer, "Location"))).isEqualTo(server.root());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "viewer/worker-", "nothing.html"})
    void shouldGuardThePage(String path) throws Exception {
        HttpResponse<byte[]> answer = get(path.startsWith("viewer") ? worker() : path);
        assertThat(answer.statusCode()).isEqualTo(path.startsWith("nothing") ? 404 : 200);
        assertThat(header(answer, "X-Content-Type-Options")).isEqualTo("nosniff");
        assertThat(header(answer, "Cross-Origin-Opener-Policy")).isEqualTo("same-origin");
        assertThat(header(answer, "Permissions-Policy")).contains("camera=()");
        assertThat(header(answer, "Content-Security-Policy"))
                .contains("default-src 'none'", "'wasm-unsafe-eval'")
                .doesNotContain("'unsafe-eval'")
                .doesNotContain("unsafe-inline");
    }

    private String worker() throws Exception {
        Matcher worker =
                Pattern.compile("viewer/worker-\\w+\\.js").matcher(new String(get("").body(), StandardCharsets.UTF_8));
        assertThat(worker.find()).isTrue();
        return worker.group();
    }

    /** A script lives by the policy of the page that asks for it. */
    @Test
    void shouldGiveScriptsNoMoreThanTheyNeed() throws Exception {
        HttpResponse<byte[]> answer = get(PageNames.script(get("").body()));
        assertThat(header(answer, "X-Content-Type-Options")).isEqualTo("nosniff");
        assertThat(answer.headers().map())
                .doesNotContainKeys("content-security-policy", "permissions-policy", "cross-origin-opener-policy");
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
        String path = PageNames.largest(".js");
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
