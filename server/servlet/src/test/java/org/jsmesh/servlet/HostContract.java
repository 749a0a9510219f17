package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import jakarta.servlet.ServletContext;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The servlet as a guest: in an application that has a front page, a page {@code about} and whatever its framework
 * brings along.
 */
@Timeout(180)
abstract class HostContract {
    static final String ABOUT = "About the host";
    private static final long PATIENCE_NANOS = 30_000_000_000L;
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    Path folder;

    private final HttpClient client =
            HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
    private Path model;
    TestServer server;

    /**
     * Starts the host.
     *
     * @param contextPath of the application: empty, or a slash and a name
     * @param guest what else is put in
     */
    abstract TestServer start(String contextPath, Consumer<ServletContext> guest) throws Exception;

    @BeforeEach
    void writeModel() throws Exception {
        model = Files.createDirectories(folder.resolve("models")).resolve("bumpy.obj");
        Files.writeString(model, bumpyGrid(30));
    }

    @AfterEach
    void stopServer() throws Exception {
        if (server != null) server.stop();
    }

    final StreamingServlet models() throws IOException {
        StoreSettings store =
                StoreSettings.of(folder.resolve("models")).withCache(Files.createDirectories(folder.resolve("cache")));
        return new StreamingServlet(store, ServletSettings.defaults());
    }

    @ParameterizedTest
    @CsvSource({"'', /models/*", "/shop, /models/*", "/shop, /of/the/museum/*"})
    void shouldServeModelsBelowAPathOfTheHost(String contextPath, String pattern) throws Exception {
        StreamingServlet models = models();
        server = start(contextPath, application -> models.mount(application, pattern));
        URI folder = server.root().resolve(pattern.substring(1, pattern.length() - 1));
        assertThat(folder.getPath()).startsWith(contextPath + "/");
        assertServes(folder);
    }

    /** Catalogue, manifest, ranges, batches and patches, by the addresses that the answers name. */
    final void assertServes(URI folder) throws Exception {
        HttpResponse<byte[]> catalogue = get(folder.resolve("index.json"));
        URI manifestAt = catalogue
                .uri()
                .resolve(JSON.readTree(catalogue.body())
                        .at("/models/0/manifestUrl")
                        .asText());
        // The model is encoded first.
        Await.until("a manifest", () -> get(manifestAt, "Accept", "text/html").statusCode() != 202);
        assertThat(get(manifestAt, "Accept", "text/html").statusCode()).isEqualTo(200);
        JsonNode manifest = JSON.readTree(get(manifestAt).body());
        URI archiveAt = manifestAt.resolve(manifest.get("archiveUrl").asText());
        assertThat(archiveAt.toString()).startsWith(folder.toString());
        byte[] archive = get(archiveAt).body();
        assertThat(MeshIdentity.sha256(ArchiveFile.of(archive).original(ProgressListener.NONE)))
                .isEqualTo(MeshIdentity.sha256(ModelFiles.read(model).mesh()));
        HttpResponse<byte[]> part = get(archiveAt, "Range", "bytes=100-299");
        assertThat(part.statusCode()).isEqualTo(206);
        assertThat(part.body()).isEqualTo(Arrays.copyOfRange(archive, 100, 300));
        assertThat(part.headers().firstValue("Content-Type")).contains("model/vnd.jsm");
        URI batches = manifestAt.resolve(manifest.get("archiveSha256").asText() + "/");
        assertThat(patches(batches)).isEqualTo(archive);

        // A browser finds no page here, and the slash behind the folder where it is missing.
        HttpResponse<byte[]> opened = get(folder, "Accept", "text/html");
        assertThat(opened.statusCode()).isEqualTo(200);
        assertThat(JSON.readTree(opened.body()).get("models")).hasSize(1);
        HttpResponse<byte[]> bare = get(URI.create(folder.toString().replaceFirst("/$", "")));
        assertThat(bare.statusCode()).isEqualTo(308);
        assertThat(bare.uri().resolve(bare.headers().firstValue("Location").orElseThrow()))
                .isEqualTo(folder);

        HttpResponse<byte[]> head = send("HEAD", archiveAt);
        assertThat(head.statusCode()).isEqualTo(200);
        assertThat(head.headers().firstValueAsLong("Content-Length")).hasValue(archive.length);
        HttpResponse<byte[]> preflight = send("OPTIONS", archiveAt, "Origin", "https://example.org");
        assertThat(preflight.statusCode()).isEqualTo(204);
        assertThat(preflight.headers().firstValue("Access-Control-Allow-Headers"))
                .hasValueSatisfying(allowed -> assertThat(allowed).contains("Range"));
        assertThat(send("DELETE", archiveAt).statusCode()).isEqualTo(405);
        HttpResponse<byte[]> nobody = get(folder.resolve("nobody/manifest.json"));
        assertThat(nobody.statusCode()).isEqualTo(404);
        assertThat(JSON.readTree(nobody.body()).get("remedy").asText()).contains("index.json");
    }

    /** The archive as the server's plan divides it. */
    private byte[] patches(URI batches) throws Exception {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (int from = 0; ; ) {
            HttpResponse<byte[]> answer =
                    get(batches.resolve("patches?from=" + from + "&bytesPerSecond=4000&waitMillis=500"));
            if (answer.statusCode() == 204) return all.toByteArray();
            assertThat(answer.statusCode()).isEqualTo(200);
            all.write(answer.body());
            URI canonical = answer.uri()
                    .resolve(answer.headers().firstValue("Content-Location").orElseThrow());
            assertThat(get(canonical).body()).isEqualTo(answer.body());
            from = Integer.parseInt(canonical.getPath().replaceFirst(".*-", "")) + 1;
        }
    }

    @ParameterizedTest
    @CsvSource({"''", "/shop"})
    void shouldLeaveThePagesOfTheHostAlone(String contextPath) throws Exception {
        server = start(contextPath, application -> {});
        List<String> alone = pagesOfTheHost();
        server.stop();
        StreamingServlet models = models();
        server = start(contextPath, application -> models.mount(application, "/models/*"));
        assertThat(get(server.root().resolve("models/index.json")).statusCode()).isEqualTo(200);
        assertThat(pagesOfTheHost()).isEqualTo(alone);
        assertThat(alone.get(0)).startsWith("200").contains("The host's own front page");
        assertThat(alone.get(1)).startsWith("200").contains(ABOUT);
        assertThat(alone.get(2)).startsWith("404");
    }

    private List<String> pagesOfTheHost() throws Exception {
        List<String> pages = new ArrayList<>();
        for (String path : List.of("", "about", "nowhere", "m/", "viewer/page.js")) {
            HttpResponse<byte[]> answer = get(server.root().resolve(path));
            Map<String, List<String>> headers = new TreeMap<>(answer.headers().map());
            headers.remove("date");
            // Frameworks tell address and time of an error.
            String body = new String(answer.body(), StandardCharsets.UTF_8)
                    .replace(server.root().getAuthority(), "")
                    .replaceAll("\"timestamp\":\\d+", "");
            pages.add(answer.statusCode() + " " + headers + " " + body);
        }
        return pages;
    }

    @Test
    void shouldHoldNothingWhenTheHostHasStopped() throws Exception {
        StreamingServlet models = models();
        server = start("", application -> models.mount(application, "/models/*"));
        assertThat(get(server.root().resolve("models/bumpy/manifest.json")).statusCode())
                .isIn(200, 202);
        assertThat(threadsOfTheStore()).isNotEmpty();
        server.stop();
        server = null;
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (!threadsOfTheStore().isEmpty() && System.nanoTime() < end) Thread.sleep(10);
        assertThat(threadsOfTheStore()).isEmpty();
        assertThat(openFiles(folder)).isEmpty();
    }

    private static List<String> threadsOfTheStore() {
        return Thread.getAllStackTraces().keySet().stream()
                .map(Thread::getName)
                .filter(name -> name.matches("jsm-(open|encode|watch)"))
                .toList();
    }

    private static List<String> openFiles(Path folder) throws IOException {
        List<String> open = new ArrayList<>();
        Path descriptors = Path.of("/proc/self/fd");
        if (!Files.isDirectory(descriptors)) return open;
        try (Stream<Path> links = Files.list(descriptors)) {
            for (Path link : links.toList()) {
                try {
                    Path file = Files.readSymbolicLink(link);
                    if (file.startsWith(folder)) open.add(file.toString());
                } catch (NoSuchFileException e) {
                    // Closed meanwhile, as that of the listing is.
                }
            }
        }
        return open;
    }

    final HttpResponse<byte[]> get(URI address, String... headers) throws Exception {
        return send("GET", address, headers);
    }

    private HttpResponse<byte[]> send(String method, URI address, String... headers) throws Exception {
        HttpRequest.Builder request =
                HttpRequest.newBuilder(address).method(method, HttpRequest.BodyPublishers.noBody());
        if (headers.length > 0) request.headers(headers);
        return client.send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
    }

    /** A height field of 2n² triangles as OBJ. */
    private static String bumpyGrid(int n) {
        StringBuilder obj = new StringBuilder();
        for (int i = 0; i < (n + 1) * (n + 1); i++) {
            int x = i % (n + 1);
            int y = i / (n + 1);
            obj.append("v " + x + " " + y + " " + (x * 7 + y * 13) % 10 / 10.0 + "\n");
        }
        for (int i = 0; i < n * n; i++) {
            int a = i / n * (n + 1) + i % n + 1;
            int b = a + n + 1;
            obj.append("f " + a + " " + (a + 1) + " " + (b + 1) + "\n");
            obj.append("f " + a + " " + (b + 1) + " " + b + "\n");
        }
        return obj.toString();
    }
}
