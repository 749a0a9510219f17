package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.session.testing.ProxiedExchange;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.test.picture.Light;
import org.jsmesh.test.picture.SoftwareRasteriser;
import org.jsmesh.test.picture.View;
import org.jsmesh.web.testing.Browser;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The page in a real Chromium, over a slow link, against the real server. Stated tolerance of pictures against the
 * software rasteriser: silhouettes agree to 98% (intersection over union), colours to {@value #COLOUR_TOLERANCE} of 255
 * in the mean over what both cover; to 9 under a fine texture, which the page filters with mipmaps and the rasteriser
 * does not.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Timeout(300)
abstract class PageFixture {
    static final int AROUND = 280;
    static final int ACROSS = 78;
    /** Bytes a second, of which two seconds bring two thirds of the model. */
    static final double LINK = 62_500;

    static final double FAST = 1e9;
    static final double COLOUR_TOLERANCE = 3;
    static final int WIDTH = 480;
    static final int HEIGHT = 360;

    @TempDir
    static Path folder;

    Path model;
    Mesh original;
    URI archiveUri;
    byte[] archive;
    ModelStore store;
    JsmServer server;
    ShapingProxy proxy;
    Browser browser;

    @BeforeAll
    void start() throws Exception {
        browser = Browser.drawingCoarsely(Files.createDirectory(folder.resolve("profile")));
        Path models = Files.createDirectory(folder.resolve("models"));
        model = GrainyTorus.write(models.resolve("torus.ply"), AROUND, ACROSS);
        original = ModelFiles.read(model).mesh();
        StoreSettings settings = StoreSettings.of(models).withCache(folder.resolve("cache"));
        EncodedOnce encoder = new EncodedOnce();
        // A busy machine may take longer than the tests wait.
        encoder.encode(model, folder.resolve("encoded.jsm"), ProgressListener.NONE);
        store = new ModelStore(settings, encoder);
        server = JsmServer.start(settings(), store);
        archive = fetchArchive();
    }

    /** How the server is set up. */
    ServerSettings settings() throws Exception {
        return ServerSettings.defaults();
    }

    @AfterAll
    void stop() throws IOException {
        if (browser != null) browser.close();
        if (server != null) server.close();
        if (store != null) store.close();
    }

    /** The page's own files are fetched before the link becomes slow; they are asked for again with their tags. */
    @BeforeEach
    void connect() throws IOException {
        if (proxy != null) proxy.close();
        proxy = ShapingProxy.to(server.uri()).bytesPerSecond(FAST);
        browser.forget();
        // Something to show of a view brings the tools.
        browser.open(URI.create(proxy.through(URI.create("http://127.0.0.1/?shading=matte&m=nothing")) + "#tools"));
        browser.await("window.jsm?.state === 'error' && document.querySelector('.tools')");
        assertThat(browser.text("#alert-text")).contains("no such model");
        browser.call("await document.getElementById('model').constructor.preload();");
        browser.consoleErrors();
    }

    /** Another address, of which the browser has nothing yet. */
    void connectWithNothingKept() throws IOException {
        proxy.close();
        proxy = ShapingProxy.to(server.uri()).bytesPerSecond(FAST);
    }

    void open(String query) {
        browser.open(
                proxy.through(URI.create("http://127.0.0.1/" + (query.isEmpty() ? "" : "?shading=matte&" + query))));
    }

    /** The page comes directly from the server, the archive alone through the link. */
    void openArchive() {
        browser.open(server.uri().resolve("?shading=matte&archive=" + proxy.through(archiveUri)));
        browser.await("window.jsm !== undefined");
    }

    String text(String expression) {
        return (String) browser.call("return " + expression + ";");
    }

    double number(String expression) {
        return ((Number) browser.call("return " + expression + ";")).doubleValue();
    }

    List<ProxiedExchange> archiveExchanges() {
        return proxy.exchanges().stream()
                .filter(e -> e.target().contains(".jsm") || e.target().contains("/patches?"))
                .toList();
    }

    /** What a round has left on its way goes on for a while. */
    void awaitSilence() {
        browser.await("jsm.keptBytes + jsm.requests.reduce((sum, r) => sum + r.bytes, 0) === jsm.bytes");
    }

    /**
     * Each range begins at the very byte at which the page stopped reading the one before; what it read to the end, it
     * read once.
     */
    void assertThatEveryByteCameOnce() {
        // The page is asked first: what it has read, the proxy has passed on.
        Map<?, ?> page = (Map<?, ?>) browser.call("""
                for (;;) {
                  const { bytes, keptBytes, requests } = jsm;
                  const read = {};
                  for (const r of requests) read[r.from ?? 0] = (read[r.from ?? 0] ?? 0) + r.bytes;
                  const all = Object.values(read).reduce((sum, some) => sum + some, 0);
                  if (keptBytes + all === bytes) return { bytes, all, read };
                  await new Promise((resolve) => setTimeout(resolve, 50));
                }
                """);
        Map<?, ?> reads = (Map<?, ?>) page.get("read");
        // What was on the wire when a response was given up never reached the page: of those that begin at the same
        // byte, the last counts.
        TreeMap<Long, ProxiedExchange> answered = new TreeMap<>();
        for (ProxiedExchange e : archiveExchanges()) if (e.bodyBytes() > 0) answered.put(e.fromByte(), e);
        long at = 0;
        for (ProxiedExchange e : answered.values()) {
            assertThat(e.status()).as(e.toString()).isEqualTo(e.target().endsWith("/first.jsm") ? 200 : 206);
            assertThat(e.fromByte()).as(e.toString()).isEqualTo(at);
            Number counted = (Number) reads.get(String.valueOf(at));
            long read = counted == null ? 0 : counted.longValue();
            long asked = Math.min(askedEnd(e), archive.length) - firstByte(e);
            if (read == asked) assertThat(e.bodyBytes()).as(e.toString()).isEqualTo(read);
            else assertThat(read).as(e.toString()).isLessThan(asked);
            at += read;
        }
        assertThat(at).isEqualTo(((Number) page.get("bytes")).longValue());
        assertThat(at).isEqualTo(((Number) page.get("all")).longValue());
    }

    static long firstByte(ProxiedExchange e) {
        if (e.range() == null) return 0; // the first bytes, which have an address of their own
        return Long.parseLong(e.range().substring("bytes=".length(), e.range().indexOf('-')));
    }

    /** The byte behind the range that was asked for. */
    static long askedEnd(ProxiedExchange e) {
        if (e.range() == null) return e.bodyBytes();
        String last = e.range().substring(e.range().indexOf('-') + 1);
        return last.isEmpty() ? Long.MAX_VALUE : Long.parseLong(last) + 1;
    }

    /** What the page shows against the same level of detail, decoded here from the archive and drawn by other means. */
    void assertThatPictureAgrees(String name) throws IOException {
        assertThatPictureAgrees(name, shown(), COLOUR_TOLERANCE);
    }

    void assertThatPictureAgrees(String name, Mesh mesh, double tolerance) throws IOException {
        Map<?, ?> camera = (Map<?, ?>) browser.call("return jsm.camera;");
        BufferedImage drawn = browser.snapshot(WIDTH, HEIGHT);
        // The page frames the model anew when its panel grows, which may happen between the two.
        for (int tries = 0; tries < 9 && !camera.equals(browser.call("return jsm.camera;")); tries++) {
            camera = (Map<?, ?>) browser.call("return jsm.camera;");
            drawn = browser.snapshot(WIDTH, HEIGHT);
        }
        View view = new View(
                vector(camera, "eye"),
                vector(camera, "target"),
                vector(camera, "up"),
                ((Number) camera.get("fieldOfView")).doubleValue());
        BufferedImage expected = new SoftwareRasteriser(mesh).draw(view, MATTE, WIDTH, HEIGHT);
        PagePictures.keep(name + "-page", drawn);
        PagePictures.keep(name + "-expected", expected);
        PagePictures.assertAgree(drawn, expected, .98, tolerance);
    }

    /** The light of the page's matte shading. */
    private static final Light MATTE = new Light(
            new double[] {.62, .64, .66},
            new double[] {.2, .19, .18},
            new double[] {.5, .49, .46},
            new double[] {-.6, .9, .7},
            new double[3],
            new double[] {0, 0, 1},
            0,
            1);

    private Mesh shown() throws IOException {
        int batches = (int) number("jsm.batches");
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, (int) number("jsm.header.ends[" + (batches - 1) + "]"));
        assertThat(decoder.batches()).isEqualTo(batches);
        return decoder.mesh();
    }

    private static double[] vector(Map<?, ?> camera, String name) {
        return ((List<?>) camera.get(name))
                .stream().mapToDouble(v -> ((Number) v).doubleValue()).toArray();
    }

    private byte[] fetchArchive() throws Exception {
        // Until then the manifest is none yet, on a busy machine.
        store.archive(store.find("torus").orElseThrow()).get();
        HttpClient client = HttpClient.newHttpClient();
        URI manifest = server.uri().resolve("m/torus/manifest.json");
        String json = client.send(HttpRequest.newBuilder(manifest).build(), HttpResponse.BodyHandlers.ofString())
                .body();
        String url = json.replaceAll(".*\"archiveUrl\":\"([^\"]+)\".*", "$1");
        archiveUri = manifest.resolve(url);
        return client.send(HttpRequest.newBuilder(archiveUri).build(), HttpResponse.BodyHandlers.ofByteArray())
                .body();
    }
}
