package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.stream.Stream;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.test.Await;
import org.jsmesh.web.testing.Browser;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The folder that {@code jsm encode --site} writes, in a sub-folder of hosts that know nothing of jSM: page,
 * {@code fetch}, and every byte.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Timeout(300)
class StaticHostsTest {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final String SIGNATURE = "X-Amz-Signature=abc%2F123&x-id=GetObject";

    @TempDir
    private static Path folder;

    private Path model;
    private Path root;
    private Path manifest;
    private Path archive;
    private String meshSha256;
    private Browser browser;

    @BeforeAll
    void write() throws Exception {
        model = GrainyTorus.write(
                Files.createDirectory(folder.resolve("models")).resolve("torus.ply"), 200, 80);
        root = folder.resolve("root");
        Path site = root.resolve("3d/site");
        Cli.ok("encode", model, "--site", site);
        manifest = site.resolve("m/torus/manifest.json");
        archive = manifest.resolveSibling(
                JSON.readTree(manifest.toFile()).get("archiveUrl").asText());
        meshSha256 = MeshIdentity.sha256(ModelFiles.read(model).mesh());
    }

    private Browser browser() throws IOException {
        if (browser == null) browser = new Browser(Files.createDirectories(folder.resolve("profile")));
        return browser;
    }

    @AfterAll
    void stop() {
        if (browser != null) browser.close();
    }

    private static URI site(URI host) {
        return host.resolve("3d/site/");
    }

    /** Gallery, one round, the original, and no complaint of the browser's. */
    private void assertThatThePageWorks(URI host) throws IOException {
        browser().consoleErrors(); // of pages before
        browser().open(site(host));
        browser().await("document.querySelectorAll('.card').length === 1");
        browser().await("document.querySelector('.card img').src.endsWith('/poster.jpg')");
        browser().await("document.querySelector('.card img').naturalWidth === 480");
        assertThat(browser().consoleErrors()).isEmpty();
        browser().click(".card");
        browser().await("['idle', 'complete', 'error'].includes(window.jsm?.state)");
        browser().call("await jsm.complete();");
        assertThat(browser().call("return jsm.error;")).isNull();
        assertThat(browser().call("return jsm.identical;")).isEqualTo(true);
        assertThat(browser().call("return jsm.sha256;")).isEqualTo(meshSha256);
        assertThat(browser().consoleErrors()).isEmpty();
    }

    private void assertThatFetchWorks(URI host) throws IOException {
        Path out = folder.resolve("fetched.ply");
        Cli.ok("fetch", site(host).resolve("m/torus/manifest.json"), "-o", out, "--full");
        assertThat(MeshIdentity.sha256(ModelFiles.read(out).mesh())).isEqualTo(meshSha256);
    }

    @Test
    void shouldStreamFromNginx() throws Exception {
        try (Nginx nginx = Nginx.start(root, folder.resolve("nginx"))) {
            assertThatThePageWorks(nginx.uri());
            assertThatFetchWorks(nginx.uri());
        }
    }

    @Test
    void shouldSendFilesFromNginxThatWerePackedWhenThePageWasBuilt() throws Exception {
        Path packed;
        try (Stream<Path> files = Files.list(root.resolve("3d/site/viewer"))) {
            packed = files.filter(file -> file.toString().endsWith(".js.gz"))
                    .findFirst()
                    .orElseThrow();
        }
        String name = packed.getFileName().toString().replaceFirst("\\.gz$", "");
        try (Nginx nginx = Nginx.start(root, folder.resolve("packed"))) {
            URI script = site(nginx.uri()).resolve("viewer/" + name);
            HttpResponse<byte[]> answer = get(script, "Accept-Encoding", "gzip");
            assertThat(answer.headers().firstValue("Content-Encoding")).contains("gzip");
            assertThat(answer.body()).isEqualTo(Files.readAllBytes(packed));
            assertThat(answer.headers().firstValue("Content-Type")).contains("text/javascript");
            assertThat(answer.headers().firstValue("Cache-Control")).contains("public, max-age=31536000, immutable");
            assertThat(answer.headers().firstValue("Vary")).contains("Accept-Encoding");
            assertThat(get(script).body()).isEqualTo(Files.readAllBytes(packed.resolveSibling(name)));
            assertThat(get(site(nginx.uri())).headers().firstValue("Cache-Control"))
                    .contains("no-cache");
        }
    }

    @Test
    void shouldStreamFromAnNginxThatCompressesEverything() throws Exception {
        String eager = "gzip on; gzip_types *; gzip_min_length 1; gzip_proxied any;";
        try (Nginx nginx = Nginx.start(root, folder.resolve("eager"), eager, "# nothing")) {
            assertThatThePageWorks(nginx.uri());
            assertThatFetchWorks(nginx.uri());
            // Even a client that takes compressed answers gets the archive as it is.
            HttpResponse<byte[]> answer = get(archiveAt(nginx.uri()), "Accept-Encoding", "gzip");
            assertThat(answer.headers().firstValue("Content-Encoding")).isEmpty();
            assertThat(answer.body()).isEqualTo(Files.readAllBytes(archive));
        }
    }

    @Test
    void shouldCopeWithAnNginxThatCompressesArchives() throws Exception {
        String eager = "gzip on; gzip_types *; gzip_min_length 1; gzip_proxied any;";
        try (Nginx nginx = Nginx.start(root, folder.resolve("wrong"), eager, "gzip off;")) {
            HttpResponse<byte[]> answer = get(archiveAt(nginx.uri()), "Accept-Encoding", "gzip");
            assertThat(answer.headers().firstValue("Content-Encoding")).contains("gzip");
            assertThatThePageWorks(nginx.uri());
            assertThatFetchWorks(nginx.uri());
        }
    }

    @Test
    void shouldShowTheNewArchiveWhenTheFileAtAnAddressIsReplaced() throws Exception {
        Path page = Files.createDirectories(folder.resolve("replaced/3d/site"))
                .getParent()
                .getParent();
        Cli.ok("encode", model, "--site", page.resolve("3d/site"));
        Path file = page.resolve("3d/site/ring.jsm");
        Files.copy(archive, file);
        Path other = folder.resolve("other.jsm");
        Cli.ok("encode", GrainyTorus.write(folder.resolve("other.ply"), 120, 60), "-o", other);
        // The proxy wants lengths, which compressed answers do not have.
        try (Nginx nginx = Nginx.start(page, folder.resolve("replacing"), "", "gzip on;");
                ShapingProxy slow = ShapingProxy.to(nginx.uri())) {
            browser().open(slow.through(site(nginx.uri())).resolve("?m=nothing"));
            browser().await("window.jsm?.state === 'error'");
            slow.bytesPerSecond(Files.size(file) / 10.0);
            browser().open(slow.through(site(nginx.uri())).resolve("?shading=matte&archive=ring.jsm"));
            browser().await("window.jsm?.state === 'idle'");
            assertThat(browser().call("return jsm.renewed;")).isNull();
            Files.move(other, file, StandardCopyOption.REPLACE_EXISTING);
            slow.bytesPerSecond(1e9);
            browser().call("await jsm.complete();");
            assertThat(browser().text("#notice")).contains("This is the new one");
            assertThat(browser().call("return jsm.identical;")).isEqualTo(true);
            assertThat(((Number) browser().call("return jsm.faces;")).intValue())
                    .isEqualTo(2 * 120 * 60);
        }
    }

    @Test
    void shouldSendTheSameBytesAsTheServletAndTheFile() throws Exception {
        byte[] file = Files.readAllBytes(archive);
        StoreSettings settings = StoreSettings.of(model.getParent()).withCache(folder.resolve("cache"));
        try (Nginx nginx = Nginx.start(root, folder.resolve("bytes"));
                ModelStore store = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
                JsmServer server = JsmServer.start(ServerSettings.defaults(), store)) {
            URI served = server.uri().resolve("m/torus/manifest.json");
            Await.until("the manifest", () -> get(served).statusCode() != 202);
            assertThat(get(served).body()).isEqualTo(Files.readAllBytes(manifest));
            URI[] places = {archiveAt(nginx.uri()), server.uri().resolve("m/torus/" + archive.getFileName())};
            int end = file.length;
            for (URI place : places) {
                HttpResponse<byte[]> whole = get(place);
                assertThat(whole.body()).as(place.toString()).isEqualTo(file);
                assertThat(whole.headers().firstValue("Accept-Ranges")).contains("bytes");
                assertThat(whole.headers().firstValue("Cache-Control").orElse(""))
                        .contains("immutable", "no-transform");
                String tag = whole.headers().firstValue("ETag").orElseThrow();
                for (int[] r : new int[][] {{0, 1}, {0, 1000}, {999, 5000}, {end - 1, end}, {0, end}}) {
                    HttpResponse<byte[]> part =
                            get(place, "Range", "bytes=" + r[0] + "-" + (r[1] - 1), "If-Range", tag);
                    assertThat(part.statusCode()).as(place.toString()).isEqualTo(206);
                    assertThat(part.headers().firstValue("Content-Range"))
                            .contains("bytes " + r[0] + "-" + (r[1] - 1) + "/" + end);
                    assertThat(part.body()).isEqualTo(Arrays.copyOfRange(file, r[0], r[1]));
                }
                assertThat(get(place, "Range", "bytes=" + end + "-").statusCode())
                        .isEqualTo(416);
                HttpResponse<byte[]> other = get(place, "Range", "bytes=0-9", "If-Range", "\"other\"");
                assertThat(other.statusCode()).isEqualTo(200);
            }
            assertThat(get(site(nginx.uri()).resolve("m/")).statusCode()).isEqualTo(200);
            assertThat(new String(get(site(nginx.uri()).resolve("m/torus/")).body(), StandardCharsets.UTF_8))
                    .contains("<title>torus · jSM</title>");
            for (String hidden : new String[] {"viewer/", ".jsm-site.lock"}) {
                int status = get(site(nginx.uri()).resolve(hidden)).statusCode();
                assertThat(status).as(hidden).isIn(403, 404);
            }
        }
    }

    @Test
    @Tag("long")
    void shouldStreamFromAHostWithoutRangesInOneAnswer() throws Exception {
        try (DumbHost host = DumbHost.withoutRanges(root);
                ShapingProxy slow = ShapingProxy.to(host.uri())) {
            assertThatThePageWorks(host.uri());
            assertThat(host.archives()).hasSizeLessThanOrEqualTo(2).allMatch(a -> a.status() == 200);
            int before = host.archives().size();
            assertThatFetchWorks(host.uri());
            assertThat(host.archives()).hasSize(before + 1);
            browser().open(slow.through(site(host.uri())).resolve("?m=nothing"));
            browser().await("window.jsm?.state === 'error'");
            assertThat(browser().text("#alert-text")).isEqualTo("There is no such model here.");
            browser().call("await document.getElementById('model').constructor.preload();");
            slow.bytesPerSecond(Files.size(archive) / 10.0);
            browser().open(slow.through(site(host.uri())).resolve("?shading=matte&m=torus"));
            browser().await("window.jsm?.state === 'idle'");
            double first = ((Number) browser().call("return jsm.bytes;")).doubleValue();
            assertThat(first).isPositive().isLessThan(Files.size(archive) / 2.0);
            browser().call("for (let i = 0; i < 5 && jsm.bytes === args[0]; i++) await jsm.refine();", first);
            double more = ((Number) browser().call("return jsm.bytes;")).doubleValue();
            assertThat(more).isGreaterThan(first);
            slow.bytesPerSecond(1e9);
            browser().call("await jsm.complete();");
            assertThat(browser().call("return jsm.identical;")).isEqualTo(true);
            String name = archive.getFileName().toString();
            assertThat(slow.exchanges())
                    .filteredOn(e -> e.target().endsWith(name))
                    .hasSize(1);
        }
    }

    @Test
    void shouldStreamFromAnObjectStoreWithSignedAddresses() throws Exception {
        Path page = Files.createDirectories(folder.resolve("page"));
        Cli.ok("encode", model, "--site", page.resolve("3d/site"));
        Path bucket = Files.createDirectories(folder.resolve("bucket"));
        Files.copy(archive, bucket.resolve("torus.jsm"));
        try (DumbHost host = DumbHost.withoutRanges(page);
                DumbHost store = DumbHost.objectStore(bucket, SIGNATURE)) {
            Path own = page.resolve("3d/site/m/torus/manifest.json");
            ObjectNode json = (ObjectNode) JSON.readTree(own.toFile());
            String address = store.uri().resolve("torus.jsm?" + SIGNATURE).toString();
            Path html = own.resolveSibling("index.html");
            String before = json.get("archiveUrl").asText();
            assertThat(Files.readString(html)).contains(before);
            Files.writeString(html, Files.readString(html).replace('"' + before + '"', '"' + address + '"'));
            JSON.writeValue(own.toFile(), json.put("archiveUrl", address));
            assertThatThePageWorks(host.uri());
            assertThatFetchWorks(host.uri());
            assertThat(store.archives()).isNotEmpty().allMatch(a -> a.method().equals("GET") && a.status() == 206);
            assertThat(host.archives()).isEmpty();
        }
    }

    private URI archiveAt(URI host) {
        return site(host).resolve("m/torus/" + archive.getFileName());
    }

    private static HttpResponse<byte[]> get(URI address, String... headers) throws IOException, InterruptedException {
        HttpRequest.Builder request = HttpRequest.newBuilder(address);
        if (headers.length > 0) request.headers(headers);
        return HttpClient.newBuilder()
                .version(HttpClient.Version.HTTP_1_1)
                .build()
                .send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
    }
}
