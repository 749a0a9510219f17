package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.session.testing.StaticFileServer;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code jsm fetch} against {@code jsm serve}'s server. */
@Timeout(120)
class FetchCommandTest {
    @TempDir
    private static Path served;

    @TempDir
    private static Path cache;

    @TempDir
    private Path folder;

    private static Path original;
    private static ModelStore store;
    private static JsmServer server;

    @BeforeAll
    static void serve() throws Exception {
        original = Bumpy.write(served.resolve("torus.ply"), 90);
        store = new ModelStore(
                StoreSettings.of(served).withCache(cache), new ModelFilesEncoder(EncoderSettings.defaults()));
        server = JsmServer.start(ServerSettings.defaults(), store);
    }

    @AfterAll
    static void stop() throws Exception {
        server.close();
        store.close();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void shouldBringTheOriginalWithATrace(boolean serverPlan) throws Exception {
        Path out = folder.resolve("torus.ply");
        Path trace = folder.resolve("trace.json");
        List<Object> line = new ArrayList<>(List.of("fetch", manifest(), "-o", out, "--full", "--trace", trace));
        if (serverPlan) line.add("--server-plan");
        assertThat(Cli.ok(line.toArray()).out())
                .contains("identical to the original file's geometry, materials and pictures, SHA-256");
        assertThat(MeshComparison.firstDifference(
                        ModelFiles.read(original).mesh(), ModelFiles.read(out).mesh()))
                .isEmpty();
        JsonNode json = new ObjectMapper().readTree(trace.toFile());
        JsonNode rounds = json.get("rounds");
        assertThat(names(rounds.get(0)))
                .containsExactly(
                        "waitMillis",
                        "plannedWaitMillis",
                        "plannedBytes",
                        "bytes",
                        "bytesPerSecond",
                        "batches",
                        "faces",
                        "errorMean");
        assertThat(rounds.get(rounds.size() - 1).get("faces").asInt()).isEqualTo(2 * 90 * 30);
        assertThat(names(json.get("requests").get(0)))
                .containsExactly("url", "range", "startMillis", "firstByteMillis", "endMillis", "bytes", "http2");
    }

    @Test
    void shouldWriteWhatItHasAfterOneRound() throws Exception {
        Path out = folder.resolve("torus.obj");
        Cli cli = Cli.ok("fetch", manifest(), "-o", out, "--wait", "1500ms");
        assertThat(cli.out()).startsWith("round 1: ");
        assertThat(ModelFiles.read(out).mesh().faces()).isPositive();
    }

    @Test
    void shouldBeginAgainWhenTheArchiveIsReplacedMeanwhile() throws Exception {
        byte[][] archives = new byte[2][];
        for (int i = 0; i < 2; i++) {
            Path model = Bumpy.write(folder.resolve(i + ".ply"), 20 + 10 * i);
            Path archive = folder.resolve(i + ".jsm");
            Cli.ok("encode", model, "-o", archive);
            archives[i] = Files.readAllBytes(archive);
        }
        AtomicInteger asked = new AtomicInteger();
        try (StaticFileServer host = StaticFileServer.withRanges()) {
            URI address = host.handle("/x.jsm", exchange -> {
                int which = Math.min(asked.getAndIncrement(), 1);
                byte[] bytes = archives[which];
                exchange.getResponseHeaders().set("ETag", "\"" + which + "\"");
                exchange.sendResponseHeaders(200, bytes.length);
                exchange.getResponseBody().write(bytes, 0, which == 0 ? bytes.length / 2 : bytes.length);
                exchange.close();
            });
            Path out = folder.resolve("x.ply");
            Cli cli = Cli.ok("fetch", address, "-o", out, "--full");
            assertThat(cli.err()).contains("the archive was replaced meanwhile");
            assertThat(cli.out())
                    .contains("identical to the original file's geometry, materials and pictures, SHA-256");
            assertThat(MeshComparison.firstDifference(
                            ModelFiles.read(folder.resolve("1.ply")).mesh(),
                            ModelFiles.read(out).mesh()))
                    .isEmpty();
        }
    }

    @Test
    void shouldAskForNothingThatItKept() throws Exception {
        Path trace = folder.resolve("trace.json");
        Object[] line = {
            "fetch",
            manifest(),
            "-o",
            folder.resolve("x.ply"),
            "--full",
            "--cache",
            folder.resolve("kept"),
            "--trace",
            trace
        };
        Cli.ok(line);
        assertThat(new ObjectMapper().readTree(trace.toFile()).get("requests").size())
                .isGreaterThan(1);
        assertThat(Cli.ok(line).out())
                .contains("identical to the original file's geometry, materials and pictures, SHA-256");
        JsonNode requests = new ObjectMapper().readTree(trace.toFile()).get("requests");
        assertThat(requests).hasSize(1);
        assertThat(requests.get(0).get("url").asText()).endsWith("manifest.json");
    }

    @Test
    void shouldPrintNothingWhenQuiet() {
        Cli cli = Cli.ok("fetch", manifest(), "-o", folder.resolve("x.ply"), "--full", "--quiet");
        assertThat(cli.out()).isEmpty();
        assertThat(cli.err()).isEmpty();
    }

    @Test
    void shouldSayWhichAddressFails() {
        Cli cli = Cli.run("fetch", server.uri().resolve("m/none/manifest.json"), "-o", folder.resolve("x.ply"));
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).containsOnlyOnce("\n").contains("m/none/manifest.json", "404");
        assertThat(folder.resolve("x.ply")).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(strings = {"ftp://127.0.0.1/x.jsm", "bunny.jsm"})
    void shouldRefuseOtherAddressesAsWrongUsage(String url) {
        Cli cli = Cli.run("fetch", url, "-o", folder.resolve("x.ply"));
        assertThat(cli.code()).isEqualTo(2);
        assertThat(cli.err()).containsOnlyOnce("\n").contains(url);
    }

    @Test
    void shouldRefuseRoundsTogetherWithFull() {
        assertThat(Cli.run("fetch", manifest(), "-o", "x.ply", "--rounds", 2, "--full")
                        .code())
                .isEqualTo(2);
        assertThat(Cli.run("fetch", manifest(), "-o", "x.ply", "--rounds", 0).code())
                .isEqualTo(2);
        assertThat(Files.exists(Path.of("x.ply"))).isFalse();
    }

    private static URI manifest() {
        return server.uri().resolve("m/torus/manifest.json");
    }

    private static List<String> names(JsonNode row) {
        List<String> names = new ArrayList<>();
        row.fieldNames().forEachRemaining(names::add);
        return names;
    }
}
