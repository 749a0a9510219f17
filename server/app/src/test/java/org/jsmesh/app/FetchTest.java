package org.jsmesh.app;

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
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.plan.BatchPlanner;
import org.jsmesh.plan.BatchRequest;
import org.jsmesh.plan.RoundPlanner;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.session.testing.ProxiedExchange;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code jsm fetch} from a real server over links that are slow and break. */
@Timeout(120)
class FetchTest {
    private static final Pattern PATCHES =
            Pattern.compile(".*/patches\\?from=(\\d+)&bytesPerSecond=(\\d+)&waitMillis=(\\d+)");

    @TempDir
    private static Path shared;

    @TempDir
    private Path folder;

    private static Path original;
    private static byte[] archive;
    private static BatchIndex index;
    private static ModelStore store;
    private static JsmServer server;
    private static URI manifest;
    private static URI archiveUrl;
    private ShapingProxy proxy;

    @BeforeAll
    static void serve() throws Exception {
        Path models = Files.createDirectories(shared.resolve("models"));
        original = Bumpy.write(shared.resolve("torus.ply"), 150);
        Path file = models.resolve("torus.jsm");
        Cli.ok("encode", original, "-o", file);
        archive = Files.readAllBytes(file);
        index = ArchiveFile.read(file).header().batches();
        StoreSettings settings = StoreSettings.of(models).withCache(shared.resolve("cache"));
        store = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
        server = JsmServer.start(ServerSettings.defaults(), store);
        manifest = server.uri().resolve("m/torus/manifest.json");
        HttpResponse<byte[]> answer = get(manifest);
        String url =
                new ObjectMapper().readTree(answer.body()).get("archiveUrl").asText();
        archiveUrl = manifest.resolve(url);
    }

    @AfterAll
    static void stop() {
        server.close();
        store.close();
    }

    @BeforeEach
    void startProxy() throws IOException {
        proxy = ShapingProxy.to(server.uri());
    }

    @AfterEach
    void stopProxy() throws IOException {
        proxy.close();
    }

    private static HttpResponse<byte[]> get(URI address) throws IOException, InterruptedException {
        return HttpClient.newHttpClient()
                .send(HttpRequest.newBuilder(address).build(), HttpResponse.BodyHandlers.ofByteArray());
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void shouldFetchTheOriginalThroughABrokenConnectionWithoutSendingAByteTwice(long seed) throws Exception {
        Random random = new Random(seed);
        URI from = random.nextBoolean() ? archiveUrl : manifest;
        long manifestBytes = from == manifest ? get(manifest).body().length : 0;
        proxy.cutAfter(manifestBytes + random.nextInt(archive.length));
        Path out = folder.resolve("torus.ply");
        Cli.ok("fetch", proxy.through(from), "-o", out, "--full");
        assertThat(MeshIdentity.sha256(ModelFiles.read(out).mesh()))
                .isEqualTo(MeshIdentity.sha256(ModelFiles.read(original).mesh()));
        List<ProxiedExchange> ranges = proxy.exchanges().stream()
                .filter(e -> e.target().endsWith(".jsm"))
                .sorted(Comparator.comparingLong(ProxiedExchange::fromByte))
                .toList();
        assertThat(ranges.size()).isGreaterThanOrEqualTo(2);
        long at = 0;
        for (ProxiedExchange e : ranges) {
            assertThat(e.fromByte()).as("%s", e).isEqualTo(at);
            at += e.bodyBytes();
        }
        assertThat(at).isEqualTo(archive.length);
    }

    @Test
    void shouldTakeAnAddressWithLettersBeyondAscii() throws Exception {
        Files.copy(shared.resolve("models/torus.jsm"), shared.resolve("models/椅子.jsm"));
        Path out = folder.resolve("chair.ply");
        Cli.ok("fetch", server.uri() + "m/椅子/manifest.json", "-o", out, "--full");
        assertThat(MeshIdentity.sha256(ModelFiles.read(out).mesh()))
                .isEqualTo(MeshIdentity.sha256(ModelFiles.read(original).mesh()));
    }

    @Test
    void shouldAskForOtherAmountsWhenTheRateChanges() throws Exception {
        Path slow = folder.resolve("slow.json");
        Path fast = folder.resolve("fast.json");
        URI address = proxy.through(manifest);
        proxy.bytesPerSecond(20_000);
        Cli.ok("fetch", address, "-o", folder.resolve("a.ply"), "--wait", "500ms", "--rounds", "3", "--trace", slow);
        proxy.bytesPerSecond(60_000);
        Cli.ok("fetch", address, "-o", folder.resolve("b.ply"), "--wait", "500ms", "--rounds", "3", "--trace", fast);
        assertThat(bytes(fast)).isGreaterThan(bytes(slow));
        JsonNode round =
                new ObjectMapper().readTree(slow.toFile()).path("rounds").get(2);
        assertThat(round.path("faces").asInt()).isPositive();
        assertThat(round.path("bytes").asLong()).isLessThan(archive.length / 2);
    }

    private static long bytes(Path trace) throws IOException {
        long sum = 0;
        for (JsonNode round : new ObjectMapper().readTree(trace.toFile()).path("rounds"))
            sum += round.path("bytes").asLong();
        return sum;
    }

    @Test
    void shouldLetTheServerPlanTheSameBatches() throws Exception {
        proxy.bytesPerSecond(100_000);
        Path out = folder.resolve("torus.ply");
        Cli.ok("fetch", proxy.through(manifest), "-o", out, "--wait", "400ms", "--rounds", "40", "--server-plan");
        int compared = 0;
        for (ProxiedExchange e : proxy.exchanges()) {
            Matcher m = PATCHES.matcher(e.target());
            if (!m.matches()) continue;
            int from = Integer.parseInt(m.group(1));
            int end = BatchPlanner.plan(index, from, Long.parseLong(m.group(2)), Long.parseLong(m.group(3)));
            assertThat(e.status()).isEqualTo(200);
            assertThat(e.bodyBytes()).isLessThanOrEqualTo(index.end(end - 1) - index.offset(from));
            compared++;
        }
        assertThat(compared).isPositive();
        assertThat(MeshIdentity.sha256(ModelFiles.read(out).mesh()))
                .isEqualTo(MeshIdentity.sha256(ModelFiles.read(original).mesh()));
    }

    @Test
    void shouldSendTheBatchesThatTheClientWouldAskForAtTheSameEstimate() throws Exception {
        Random random = new Random(3);
        for (int i = 0; i < 20; i++) {
            RoundPlanner planner = new RoundPlanner();
            int portion = 400 + random.nextInt(3000);
            planner.sent(0);
            for (int k = 0; k < 20; k++) planner.arrived(50 + 100 * k, portion);
            planner.ended(false);
            int held = 1 + random.nextInt(index.size() - 1);
            planner.beginRound(3000, 500 + random.nextInt(2000));
            BatchRequest asked = planner.next(3000, index, index.offset(held));
            URI patches = URI.create(archiveUrl.toString().replace(".jsm", "/patches") + "?from=" + asked.fromBatch()
                    + "&bytesPerSecond=" + asked.bytesPerSecond() + "&waitMillis=" + asked.waitMillis());
            assertThat(get(patches).body())
                    .isEqualTo(Arrays.copyOfRange(archive, (int) asked.fromByte(), (int) asked.endByte()));
        }
    }
}
