package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.store.ids.ModelIds;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code jsm encode --site}: the folder that it writes, and what a second run does to it. */
class EncodeSiteTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    private Path models;
    private Path site;

    @BeforeEach
    void makeModels() throws IOException {
        models = Files.createDirectories(folder.resolve("models/a")).getParent();
        Files.createDirectory(models.resolve("b"));
        Bumpy.write(models.resolve("Big Ring.ply"), 30);
        Bumpy.write(models.resolve("a/same.ply"), 12);
        Bumpy.write(models.resolve("b/same.ply"), 14);
        Bumpy.write(models.resolve("椅子.ply"), 10);
        site = folder.resolve("site");
    }

    @Test
    void shouldAnswerEveryAddressAsTheServletDoes() throws Exception {
        Cli.ok("encode", models, "--site", site);
        StoreSettings settings = StoreSettings.of(models).withCache(folder.resolve("cache"));
        HttpClient client = HttpClient.newHttpClient();
        try (ModelStore store = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
                JsmServer server = JsmServer.start(ServerSettings.defaults(), store)) {
            List<Path> files;
            try (Stream<Path> walk = Files.walk(site)) {
                files = walk.filter(Files::isRegularFile)
                        .map(site::relativize)
                        .filter(f -> !f.toString().startsWith("."))
                        .sorted()
                        .toList();
            }
            assertThat(files).hasSizeGreaterThan(15);
            // Manifests first: asking for them makes the servlet encode, so that its catalogue knows all.
            for (Path file : files) if (file.endsWith("manifest.json")) assertSame(client, server.uri(), file);
            for (Path file : files) {
                // The page has its policy in itself here; the servlet sends what is packed by another address.
                boolean differs = file.endsWith("index.html") || file.toString().matches(".*\\.(gz|br)");
                if (!differs && !file.endsWith("index.json")) assertSame(client, server.uri(), file);
            }
            JsonNode here = JSON.readTree(Files.readAllBytes(site.resolve("m/index.json")));
            JsonNode there = JSON.readTree(get(client, server.uri().resolve("m/index.json")));
            assertThat(here.get("models")).hasSize(4);
            for (int i = 0; i < 4; i++) {
                // The servlet has the model files, the site has archives only.
                for (String member : List.of("format", "fileBytes", "modified")) {
                    ((ObjectNode) here.get("models").get(i)).remove(member);
                    ((ObjectNode) there.get("models").get(i)).remove(member);
                }
            }
            assertThat(here).isEqualTo(there);
            assertThat(here.findValuesAsText("id")).containsExactly("a--same", "b--same", "big-ring", "椅子-ply-mipqtj");
        }
    }

    private void assertSame(HttpClient client, URI server, Path file) throws Exception {
        String path = file.toString().replace('\\', '/');
        byte[] there = get(client, server.resolve(ModelIds.segment(path).replace("%2F", "/")));
        assertThat(there).as(file.toString()).isEqualTo(Files.readAllBytes(site.resolve(file)));
    }

    private static byte[] get(HttpClient client, URI address) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(address).build();
        // A busy machine takes longer than a request waits; what waits for the archive is 202 or 503 until then.
        Await.until("an answer to " + address, () -> {
            int status =
                    client.send(request, HttpResponse.BodyHandlers.discarding()).statusCode();
            return status != 202 && status != 503;
        });
        HttpResponse<byte[]> answer = client.send(request, HttpResponse.BodyHandlers.ofByteArray());
        assertThat(answer.statusCode()).as(address.toString()).isEqualTo(200);
        return answer.body();
    }

    @Test
    void shouldGuardThePageWhereTheHostSendsNoHeaders() throws IOException {
        Cli.ok("encode", models.resolve("a/same.ply"), "--site", site);
        assertThat(site.resolve("index.html"))
                .content()
                .contains("http-equiv=\"Content-Security-Policy\"", "default-src 'none'", "'wasm-unsafe-eval'")
                .doesNotContain("frame-ancestors", "unsafe-inline");
    }

    @Test
    void shouldTellTheArchivesPlacesAsJson() throws IOException {
        Path bad = Files.writeString(folder.resolve("bad.ply"), "ply\nnonsense\n");
        Cli cli = Cli.run("encode", bad, models.resolve("a/same.ply"), "--site", site, "--json");
        assertThat(cli.code()).isEqualTo(1);
        JsonNode rows = JSON.readTree(cli.out());
        assertThat(rows.get(0).get("error").asText()).contains("bad.ply");
        Path archive = Path.of(rows.get(1).get("output").asText());
        assertThat(archive).exists().hasParent(site.resolve("m/same"));
        assertThat(site.resolve("m/bad")).doesNotExist();
        assertThat(JSON.readTree(site.resolve("m/index.json").toFile()).findValuesAsText("id"))
                .containsExactly("same");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "INPUT --site OUT",
                "--site OUT INPUT",
                "INPUT --site -o OUT",
                "INPUT -o OUT --site",
                "--site INPUT -o OUT"
            })
    void shouldTakeTheFolderEitherWay(String line) {
        Object[] words = ("encode " + line)
                .replace("INPUT", models.resolve("a/same.ply").toString())
                .replace("OUT", site.toString())
                .split(" ");
        Cli.ok(words);
        assertThat(site.resolve("m/same/manifest.json")).exists();
        assertThat(site.resolve("index.html")).exists();
    }

    @Test
    void shouldPublishAnnotationsThatStandBesideTheModel() throws IOException {
        Path model = models.resolve("a/same.ply");
        Path written = Files.writeString(models.resolve("a/same.annotations.json"), "{\"annotations\": []}");
        Cli.ok("encode", model, "--site", site);
        Path published = site.resolve("m/same/annotations.json");
        Path manifest = site.resolve("m/same/manifest.json");
        assertThat(published).hasContent("{\"annotations\": []}");
        assertThat(manifest).content().contains("\"annotationsUrl\":\"annotations.json\"");
        Files.delete(written);
        Cli.ok("encode", model, "--site", site);
        assertThat(published).doesNotExist();
        assertThat(manifest).content().doesNotContain("annotationsUrl");
    }

    @Test
    void shouldWriteNothingAnewThatDoesNotChange() throws IOException {
        Cli.ok("encode", models, "--site", site);
        Map<Path, FileTime> before = times(FileTime.from(Instant.now().minus(Duration.ofHours(1))));
        Cli.ok("encode", models, "--site", site);
        assertThat(times(null)).isEqualTo(before);
    }

    @Test
    void shouldKeepTheArchiveBeforeForADay() throws IOException {
        Path model = models.resolve("a/same.ply");
        Cli.ok("encode", model, "--site", site);
        Path first = archives().get(0);
        Bumpy.write(model, 16);
        Cli.ok("encode", model, "--site", site);
        assertThat(archives()).hasSize(2).contains(first);
        Cli.ok("encode", models.resolve("b/same.ply"), "--site", site);
        assertThat(archives()).hasSize(3);
        for (Path archive : archives()) {
            long hours = archive.equals(first) ? 60 : 40;
            Files.setLastModifiedTime(archive, FileTime.from(Instant.now().minus(Duration.ofHours(hours))));
        }
        Cli.ok("encode", models.resolve("b/same.ply"), "--site", site);
        JsonNode manifest = JSON.readTree(site.resolve("m/same/manifest.json").toFile());
        assertThat(archives())
                .doesNotContain(first)
                .contains(site.resolve("m/same/" + manifest.get("archiveUrl").asText()));
    }

    @Test
    void shouldKeepOtherModelsUnlessToldToPrune() throws IOException {
        Cli.ok("encode", models.resolve("Big Ring.ply"), "--site", site);
        Cli.ok("encode", models.resolve("a/same.ply"), "--site", site);
        assertThat(site.resolve("m/index.json")).content().contains("big-ring", "same");
        Cli.ok("encode", models.resolve("a/same.ply"), "--site", site, "--prune");
        assertThat(site.resolve("m/index.json"))
                .content()
                .doesNotContain("big-ring")
                .contains("same");
        assertThat(site.resolve("m/big-ring")).doesNotExist();
    }

    @Test
    void shouldTakeArchivesAsTheyAre() throws IOException {
        Path archive = folder.resolve("Ready Made.jsm");
        Cli.ok("encode", models.resolve("Big Ring.ply"), "-o", archive);
        Path cut = folder.resolve("cut.jsm");
        byte[] bytes = Files.readAllBytes(archive);
        Files.write(cut, Arrays.copyOf(bytes, bytes.length - 9));
        Cli cli = Cli.run("encode", archive, models.resolve("a/same.ply"), cut, "--site", site, "--json");
        assertThat(cli.code()).isEqualTo(1);
        JsonNode rows = JSON.readTree(cli.out());
        assertThat(Path.of(rows.get(0).get("output").asText())).hasBinaryContent(bytes);
        assertThat(rows.get(0).get("faces").asInt()).isEqualTo(2 * 30 * 10);
        assertThat(rows.get(1).get("output").asText()).contains("same");
        assertThat(rows.get(2).get("error").asText()).contains("cut.jsm", "the file is cut");
        assertThat(JSON.readTree(site.resolve("m/index.json").toFile()).findValuesAsText("id"))
                .containsExactly("ready-made", "same");
        assertThat(archive).exists();
    }

    @Test
    void shouldLeaveNothingBehindOfARunThatWasKilled() throws IOException {
        Files.createDirectories(site.resolve(".encoding/x"));
        Files.writeString(site.resolve(".encoding/x/half.jsm.part"), "half");
        Cli.ok("encode", models.resolve("a/same.ply"), "--site", site);
        assertThat(site.resolve(".encoding")).doesNotExist();
    }

    @Test
    void shouldNotWriteIntoTheSiteOfSomebodyElse() throws IOException {
        Files.createDirectory(site);
        Files.writeString(site.resolve("index.html"), "<h1>My cat</h1>");
        Cli cli = Cli.run("encode", models, "--site", site);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).contains("index.html", "another site", "Choose another folder");
        assertThat(site.resolve("index.html")).hasContent("<h1>My cat</h1>");
    }

    @Test
    void shouldSayWhatIsMissing() {
        assertThat(Cli.run("encode", models).err()).contains("--output", "--site");
        assertThat(Cli.run("encode", "-o", site).err()).contains("INPUT");
        Cli prune = Cli.run("encode", models, "-o", site, "--prune");
        assertThat(prune.code()).isEqualTo(2);
        assertThat(prune.err()).contains("--prune goes with --site");
    }

    private List<Path> archives() throws IOException {
        try (Stream<Path> files = Files.list(site.resolve("m/same"))) {
            return files.filter(f -> f.toString().endsWith(".jsm")).toList();
        }
    }

    private Map<Path, FileTime> times(FileTime set) throws IOException {
        Map<Path, FileTime> times = new TreeMap<>();
        try (Stream<Path> walk = Files.walk(site)) {
            for (Path file : walk.filter(Files::isRegularFile).toList()) {
                if (set != null) Files.setLastModifiedTime(file, set);
                if (!file.endsWith(".jsm-site.lock")) times.put(file, Files.getLastModifiedTime(file));
            }
        }
        return times;
    }
}
