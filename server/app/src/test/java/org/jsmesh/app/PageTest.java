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
import java.util.stream.Stream;
import org.jsmesh.archive.ArchiveDecoder;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encoder.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.session.testing.Exchange;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.store.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.test.picture.Light;
import org.jsmesh.test.picture.SoftwareRasteriser;
import org.jsmesh.test.picture.View;
import org.jsmesh.web.testing.Browser;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The page in a real Chromium, over a link of 1 Mbit/s, against the real server. Stated tolerance of pictures against the software rasteriser: silhouettes agree to
 * 98% (intersection over union), colours to {@value #COLOUR_TOLERANCE} of 255 in the mean over what both cover;
 * to 9 under a fine texture, which the page filters with mipmaps and the rasteriser does not.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Timeout(300)
class PageTest {
    private static final double MEGABIT = 125_000;
    private static final double FAST = 1e9;
    private static final double COLOUR_TOLERANCE = 3;
    private static final int WIDTH = 480;
    private static final int HEIGHT = 360;

    @TempDir
    static Path folder;

    private Path model;
    private Mesh original;
    private URI archiveUri;
    private byte[] archive;
    private ModelStore store;
    private JsmServer server;
    private ShapingProxy proxy;
    private Browser browser;

    @BeforeAll
    void start() throws Exception {
        browser = new Browser(Files.createDirectory(folder.resolve("profile")));
        Path models = Files.createDirectory(folder.resolve("models"));
        model = GrainyTorus.write(models.resolve("torus.ply"), 400, 110);
        original = ModelFiles.read(model).mesh();
        StoreSettings settings = StoreSettings.of(models).withCache(folder.resolve("cache"));
        store = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
        server = JsmServer.start(ServerSettings.defaults(), store);
        archive = fetchArchive();
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
        open("m=nothing");
        browser.await("window.jsm?.state === 'error'");
        assertThat(browser.text("#alert-text")).contains("no such model");
        browser.consoleErrors();
    }

    @Test
    void shouldListTheModelsWithAPictureEach() {
        open("");
        browser.await("document.querySelectorAll('.card').length === 1");
        browser.await("document.querySelectorAll('.card img.empty').length === 0");
        assertThat(browser.text(".card")).contains("torus", "88,000 faces");
        assertThat((Long) browser.call("return document.querySelector('.card img').naturalWidth;"))
                .isEqualTo(640);
        assertThat(browser.consoleErrors()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"wasm", "js"})
    void shouldRefineToTheOriginalAndProveIt(String decoder) throws IOException {
        proxy.bytesPerSecond(MEGABIT);
        open("m=torus&decoder=" + decoder);
        browser.await("window.jsm?.state === 'idle'");
        assertThat(text("jsm.decoder")).isEqualTo(decoder);
        assertThat(number("jsm.firstPicture.bytes")).isLessThan(.03 * archive.length);
        assertThat(number("jsm.faces")).isBetween(100.0, 88_000.0);
        assertThat(number("jsm.bytes")).isLessThan(archive.length);
        assertThat(number("jsm.totalFaces")).isEqualTo(88_000);
        assertThat(browser.isShown("#proof")).isFalse();
        assertThat(archiveExchanges())
                .allMatch(e -> e.range() != null && !e.range().endsWith("-"));
        assertThatPictureAgrees("middle-" + decoder);

        proxy.bytesPerSecond(FAST);
        browser.click("#original");
        browser.await("jsm.state === 'complete'");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(text("jsm.sha256")).isEqualTo(MeshIdentity.sha256(original));
        assertThat(browser.text("#proof")).isEqualTo("identical to the original");
        assertThatPictureAgrees("end-" + decoder);
        assertThatEveryByteCameOnce();
        assertThat(browser.consoleErrors()).isEmpty();
    }

    /** Vertex colours, materials, and a texture with seams. */
    @ParameterizedTest
    @CsvSource({"octopus, 3", "planetary-gear, 3", "amphora, 9"})
    void shouldDrawTheSampleModels(String name, double tolerance) throws Exception {
        Path samples = Path.of("..", "..", "models");
        StoreSettings settings = StoreSettings.of(samples).withCache(folder.resolve("cache"));
        try (ModelStore sampleStore = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
                JsmServer sampleServer = JsmServer.start(ServerSettings.defaults(), sampleStore)) {
            browser.open(sampleServer.uri().resolve("?shading=matte&m=" + name));
            browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
            browser.call("await jsm.complete();");
            assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
            browser.await("jsm.texturesLoading === 0");
            assertThatPictureAgrees(name, sample(samples, name), tolerance);
        }
        assertThat(browser.consoleErrors()).isEmpty();
    }

    private static Mesh sample(Path folder, String name) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            Path file = files.filter(f -> f.getFileName().toString().matches(name + "\\.(ply|obj)"))
                    .findFirst()
                    .orElseThrow();
            return ModelFiles.read(file).mesh();
        }
    }

    @Test
    void shouldShowTheBaseFirst() throws IOException {
        proxy.bytesPerSecond(4000);
        open("m=torus");
        browser.await("window.jsm?.pictures > 0");
        browser.call("jsm.stop();");
        browser.await("jsm.state === 'idle'");
        assertThat(number("jsm.faces")).isLessThan(.05 * original.faces());
        assertThatPictureAgrees("base");
        assertThat(browser.consoleErrors()).isEmpty();
    }

    @Test
    void shouldWaitForTheBaseBeyondTheEndOfTheRound() throws IOException {
        proxy.bytesPerSecond(300);
        openArchive();
        browser.await("window.jsm?.bytes > 0 && document.getElementById('wait-text').textContent.includes('received')");
        assertThat(text("jsm.state")).isEqualTo("loading");
        browser.await("performance.now() - jsm.rounds[0].at > 3000");
        assertThat(text("jsm.state")).isEqualTo("loading");
        proxy.bytesPerSecond(4000);
        browser.await("jsm.state !== 'loading' && jsm.state !== 'refining'");
        assertThat(text("jsm.state")).isEqualTo("idle");
        assertThat(number("jsm.rounds.length")).isEqualTo(1);
        assertThat(number("jsm.firstPicture.millis - jsm.rounds[0].at")).isGreaterThan(2000);
        assertThatPictureAgrees("late-base");
    }

    @Test
    void shouldWaitForAFirstByteThatComesAfterTheRound() {
        proxy.delayMillis(2500);
        openArchive();
        browser.await("jsm.state !== 'loading' && jsm.state !== 'refining'");
        assertThat(text("jsm.state")).isEqualTo("idle");
        assertThat(browser.call("return jsm.error;")).isNull();
        assertThat(number("jsm.faces")).isGreaterThan(0);
    }

    @Test
    void shouldSayThatAnArchiveCannotBeFetchedAndTryAgain() throws IOException {
        int port = proxy.port();
        proxy.close();
        openArchive();
        browser.await(
                "window.jsm?.state === 'loading' && document.getElementById('wait-text').textContent.includes('trying again')");
        browser.await("jsm.state === 'error'");
        assertThat(browser.text("#alert-text")).contains("127.0.0.1:" + port + "/", "cannot be fetched");
        assertThat(browser.isShown("#wait")).isFalse();
        browser.click("#retry");
        browser.await("jsm.state === 'loading'");
        browser.await("jsm.state === 'error'");
    }

    @Test
    void shouldSayThatAnAddressIsNone() {
        browser.open(server.uri().resolve("?archive=//x:99999/"));
        browser.await("window.jsm?.state === 'error'");
        assertThat(browser.text("#alert-text")).contains("\"//x:99999/\"", "not the address of an archive");
        assertThat(browser.isShown("#retry")).isFalse();
    }

    @Test
    void shouldSayWhichDecoderCannotBeLoaded() {
        proxy.refuse("/decoder.wasm");
        open("m=torus&decoder=wasm");
        browser.await("window.jsm?.state === 'error'");
        // The round that was wished meanwhile ends, too, and must not hide the reason.
        browser.call("await jsm.refine();");
        assertThat(browser.text("#alert-text"))
                .contains("The decoder could not be loaded", "decoder.wasm: HTTP status 500");
        assertThat(browser.isShown("#retry")).isFalse();
    }

    @Test
    void shouldDecodeWithJavaScriptWhereWebAssemblyCannotBeLoaded() {
        proxy.refuse("/decoder.wasm");
        open("m=torus");
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        assertThat(text("jsm.decoder")).isEqualTo("js");
    }

    @Test
    void shouldAskForLessWhenTheLinkGetsSlower() {
        proxy.bytesPerSecond(MEGABIT);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        double first = number("jsm.rounds[0].to - jsm.rounds[0].from");
        assertThat(first).isBetween(.5 * 2 * MEGABIT, 1.3 * 2 * MEGABIT);
        proxy.bytesPerSecond(MEGABIT / 16);
        browser.click("#more");
        browser.await("jsm.state === 'idle' && jsm.rounds.length === 2");
        browser.click("#more");
        browser.await("(jsm.state === 'idle' || jsm.state === 'complete') && jsm.rounds.length === 3");
        double third = number("jsm.rounds[2].to - jsm.rounds[2].from");
        assertThat(third).isLessThan(.5 * first);
        assertThatEveryByteCameOnce();
    }

    @Test
    void shouldAskForLessInTheSecondRoundOfASlowerLink() throws IOException {
        long faster = askedInTheSecondRound(MEGABIT / 2);
        connect();
        long slower = askedInTheSecondRound(MEGABIT / 8);
        assertThat(slower).isBetween(faster / 8, faster / 2);
    }

    /** Bytes of the ranges that the second round asks for, as they pass on the wire. */
    private long askedInTheSecondRound(double bytesPerSecond) {
        proxy.bytesPerSecond(bytesPerSecond);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        int first = archiveExchanges().size();
        browser.click("#more");
        browser.await("jsm.state === 'idle' && jsm.rounds.length === 2");
        List<Exchange> second = archiveExchanges().stream().skip(first).toList();
        assertThat(second).isNotEmpty();
        // What one request leaves out the next may ask for again: it counts how far the round would go.
        long end = second.stream().mapToLong(PageTest::askedEnd).max().orElseThrow();
        return end - firstByte(second.get(0));
    }

    @Test
    void shouldLetTheServerPlan() {
        proxy.bytesPerSecond(MEGABIT);
        open("m=torus");
        browser.call("document.getElementById('server-plan').click();");
        browser.await("window.jsm?.state === 'idle'");
        browser.click("#more");
        browser.await("jsm.state === 'complete' || jsm.state === 'idle' && jsm.rounds.length === 2");
        proxy.bytesPerSecond(FAST);
        browser.call("await jsm.complete();");
        assertThat(archiveExchanges().stream().filter(e -> e.target().contains("/patches?")))
                .isNotEmpty();
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(number("jsm.requests.reduce((sum, r) => sum + r.bytes, 0)")).isEqualTo(archive.length);
        assertThat(browser.consoleErrors()).isEmpty();
    }

    @Test
    void shouldReadOnByRangesWhenTheConnectionBreaksThatTheServerPlanned() {
        proxy.bytesPerSecond(MEGABIT / 4);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        browser.call("document.getElementById('server-plan').click();");
        browser.call("await jsm.refine();"); // makes whole the batch that was cut
        proxy.cutAfter(10_000);
        browser.call("await jsm.refine();");
        assertThat(browser.call("return jsm.error;")).isNull();
        assertThat(number("jsm.rounds.length")).isEqualTo(3);
        String resumed =
                "jsm.requests.some((r, i, all) => all[i - 1]?.url.includes('/patches?') && all[i - 1].bytes > 0"
                        + " && r.from === all.slice(0, i).reduce((sum, other) => sum + other.bytes, 0) && r.bytes > 0)";
        assertThat(browser.call("return " + resumed + ";")).isEqualTo(true);
        proxy.bytesPerSecond(FAST);
        browser.call("await jsm.complete();");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(number("jsm.requests.reduce((sum, r) => sum + r.bytes, 0)")).isEqualTo(archive.length);
    }

    @Test
    void shouldReadAnAnswerThatBeginsAfterTheRoundToItsEnd() {
        proxy.bytesPerSecond(MEGABIT / 4);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.delayMillis(2500);
        browser.call("await jsm.refine();");
        assertThat(text("jsm.state")).isEqualTo("idle");
        assertThat(number("jsm.rounds[1].plans.length")).isEqualTo(1);
        assertThat(number("jsm.requests.at(-1).bytes"))
                .isEqualTo(number("jsm.requests.at(-1).end - jsm.requests.at(-1).from"));
        assertThatEveryByteCameOnce();
    }

    @Test
    void shouldSayThatTheServerIsSilentAndTryAgain() {
        proxy.bytesPerSecond(MEGABIT / 4);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.delayMillis(60_000);
        browser.click("#more");
        browser.await("jsm.state === 'error'");
        assertThat(browser.text("#alert-text")).contains("The server is silent", "10 s");
        proxy.delayMillis(0);
        double bytes = number("jsm.bytes");
        browser.click("#retry");
        browser.await("jsm.state === 'idle' || jsm.state === 'complete'");
        assertThat(number("jsm.bytes")).isGreaterThan(bytes);
    }

    @Test
    void shouldResumeAtTheByteWhereTheConnectionBroke() {
        proxy.bytesPerSecond(MEGABIT);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.bytesPerSecond(4 * MEGABIT).cutAfter(54_321);
        browser.click("#original");
        browser.await("jsm.state === 'complete' || jsm.state === 'error'");
        assertThat(browser.call("return jsm.error;")).isNull();
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(archiveExchanges()).anyMatch(e -> e.ifRange() != null);
        assertThatEveryByteCameOnce();
    }

    @Test
    void shouldReportADamagedArchiveAndNeverCallItIdentical() {
        proxy.bytesPerSecond(MEGABIT);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        double faces = number("jsm.faces");
        proxy.bytesPerSecond(FAST).corruptByte(archive.length - 1000L);
        browser.click("#original");
        browser.await("jsm.state === 'complete' || jsm.state === 'error'");
        assertThat(text("jsm.state")).isEqualTo("error");
        assertThat(browser.text("#alert-text")).contains("The archive is damaged");
        assertThat(browser.isShown("#retry")).isFalse();
        assertThat(browser.call("return jsm.identical;")).isEqualTo(false);
        assertThat(browser.isShown("#proof")).isFalse();
        assertThat(number("jsm.faces")).isGreaterThanOrEqualTo(faces);
    }

    @ParameterizedTest
    @ValueSource(strings = {"#original", "#more"})
    void shouldSayInWordsThatTheServerIsGone(String button) throws IOException {
        proxy.bytesPerSecond(MEGABIT);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.close();
        browser.click(button);
        browser.await("document.getElementById('wait-text').textContent.includes('trying again (5 of 5)')");
        browser.await("jsm.state !== 'refining'");
        assertThat(text("jsm.state")).isEqualTo("error");
        assertThat(browser.text("#alert-text")).contains("did not come back");
        assertThat(browser.isShown("#retry")).isTrue();
    }

    private void open(String query) {
        browser.open(
                proxy.through(URI.create("http://127.0.0.1/" + (query.isEmpty() ? "" : "?shading=matte&" + query))));
    }

    /** The page comes directly from the server, the archive alone through the link. */
    private void openArchive() {
        browser.open(server.uri().resolve("?shading=matte&archive=" + proxy.through(archiveUri)));
        browser.await("window.jsm !== undefined");
    }

    private String text(String expression) {
        return (String) browser.call("return " + expression + ";");
    }

    private double number(String expression) {
        return ((Number) browser.call("return " + expression + ";")).doubleValue();
    }

    private List<Exchange> archiveExchanges() {
        return proxy.exchanges().stream()
                .filter(e -> e.target().contains(".jsm") || e.target().contains("/patches?"))
                .toList();
    }

    /** Each range begins at the very byte at which the page stopped reading the one before; what it read to the end, it read once. */
    private void assertThatEveryByteCameOnce() {
        // What was on the wire when a response was given up never reached the page: of those that begin at the same
        // byte, the last counts.
        TreeMap<Long, Exchange> answered = new TreeMap<>();
        for (Exchange e : archiveExchanges()) if (e.bodyBytes() > 0) answered.put(e.fromByte(), e);
        long at = 0;
        for (Exchange e : answered.values()) {
            assertThat(e.status()).as(e.toString()).isEqualTo(206);
            assertThat(e.fromByte()).as(e.toString()).isEqualTo(at);
            long read = (long)
                    number("jsm.requests.filter(r => r.from === " + at + ").reduce((sum, r) => sum + r.bytes, 0)");
            long asked = Math.min(askedEnd(e), archive.length) - firstByte(e);
            if (read == asked) assertThat(e.bodyBytes()).as(e.toString()).isEqualTo(read);
            else assertThat(read).as(e.toString()).isLessThan(asked);
            at += read;
        }
        assertThat(at).isEqualTo((long) number("jsm.bytes"));
        assertThat(number("jsm.requests.reduce((sum, r) => sum + r.bytes, 0)")).isEqualTo(at);
    }

    private static long firstByte(Exchange e) {
        return Long.parseLong(e.range().substring("bytes=".length(), e.range().indexOf('-')));
    }

    /** The byte behind the range that was asked for. */
    private static long askedEnd(Exchange e) {
        String last = e.range().substring(e.range().indexOf('-') + 1);
        return last.isEmpty() ? Long.MAX_VALUE : Long.parseLong(last) + 1;
    }

    /** What the page shows against the same level of detail, decoded here from the archive and drawn by other means. */
    private void assertThatPictureAgrees(String name) throws IOException {
        assertThatPictureAgrees(name, shown(), COLOUR_TOLERANCE);
    }

    private void assertThatPictureAgrees(String name, Mesh mesh, double tolerance) throws IOException {
        Map<?, ?> camera = (Map<?, ?>) browser.call("return jsm.camera;");
        BufferedImage drawn = browser.snapshot(WIDTH, HEIGHT);
        View view = new View(
                vector(camera, "eye"),
                vector(camera, "target"),
                vector(camera, "up"),
                ((Number) camera.get("fieldOfView")).doubleValue());
        BufferedImage expected = new SoftwareRasteriser(mesh).draw(view, MATTE, WIDTH, HEIGHT);
        Pictures.keep(name + "-page", drawn);
        Pictures.keep(name + "-expected", expected);
        Pictures.assertAgree(drawn, expected, .98, tolerance);
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

    private byte[] fetchArchive() throws IOException, InterruptedException {
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
