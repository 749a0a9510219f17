package org.jsmesh.site;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;
import org.jsmesh.objects.FolderObjectStore;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CatalogueWriterTest {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int PAGE = 10;
    private static final int ROOT = 4;

    @TempDir
    private Path folder;

    private CountingStore store;
    private CatalogueWriter writer;
    private Instant now = Instant.now();

    @BeforeEach
    void open() {
        store = new CountingStore(new FolderObjectStore(folder));
        writer = new CatalogueWriter(store, PAGE, ROOT);
    }

    static CatalogueRow row(String id, int version) {
        String hash = String.format("%064x", version);
        return new CatalogueRow(
                id,
                "{\"id\":\"" + id + "\",\"archiveSha256\":\"" + hash + "\",\"bounds\":[0.1,1.0E10],\"modified\":\"v"
                        + version + "\"}");
    }

    private Map<String, String> read() throws IOException {
        Map<String, String> rows = new TreeMap<>();
        CatalogueReader reader = new CatalogueReader(store);
        reader.forEach(row -> assertThat(rows.put(row.id(), row.json())).isNull());
        assertThat(reader.total()).isEqualTo(rows.size());
        return rows;
    }

    /** What clients rely on. */
    private void assertForm() throws IOException {
        JsonNode root = JSON.readTree(folder.resolve("m/index.json").toFile());
        int total = root.get("models").size();
        String last = "";
        for (JsonNode row : root.get("models")) {
            assertThat(row.get("id").asText()).isGreaterThan(last);
            last = row.get("id").asText();
        }
        int before = PAGE;
        for (JsonNode page : root.path("pages")) {
            JsonNode models = JSON.readTree(
                            folder.resolve("m/" + page.get(2).asText()).toFile())
                    .get("models");
            assertThat(page.get(0).asText())
                    .isGreaterThan(last)
                    .isEqualTo(models.at("/0/id").asText());
            assertThat(models.size()).isEqualTo(page.get(1).asInt()).isBetween(1, PAGE);
            assertThat(before + models.size()).isGreaterThan(PAGE);
            for (JsonNode row : models) last = row.get("id").asText();
            total += models.size();
            before = models.size();
        }
        assertThat(root.get("total").asInt()).isEqualTo(total);
        assertThat(root.has("pages")).isEqualTo(total > PAGE);
        if (total > PAGE) assertThat(root.get("models").size()).isBetween(1, ROOT);
    }

    @Test
    void shouldKeepAFewModelsInOneObject() throws Exception {
        assertThat(writer.update(List.of()).total()).isZero();
        assertThat(Files.readString(folder.resolve("m/index.json"))).isEqualTo("{\"total\":0,\"models\":[]}");
        writer.update(List.of(row("b", 1)));
        writer.update(List.of(row("a", 2)));
        assertThat(Files.readString(folder.resolve("m/index.json")))
                .isEqualTo("{\"total\":2,\"models\":[" + row("a", 2).json() + ","
                        + row("b", 1).json() + "]}");
        assertThat(files()).containsExactly("index.json");
    }

    @Test
    void shouldHoldWhatManyChangesLeave() throws Exception {
        for (int seed = 0; seed < 6; seed++) {
            Random random = new Random(seed);
            Map<String, String> expected = new TreeMap<>(read());
            for (int step = 0; step < 40; step++) {
                TreeMap<String, CatalogueRow> changes = new TreeMap<>();
                int count = step % 8 == 0 ? 60 : random.nextInt(6);
                boolean isShrinking = step % 16 > 10;
                for (int i = 0; i < count; i++) {
                    String id = String.format("m%03d", random.nextInt(120));
                    boolean isRemoval = random.nextInt(10) < (isShrinking ? 8 : 2);
                    changes.put(id, isRemoval ? CatalogueRow.removal(id) : row(id, random.nextInt(1000)));
                }
                writer.update(changes.values(), now);
                changes.forEach((id, row) -> {
                    if (row.isRemoval()) expected.remove(id);
                    else if (!isSameArchive(expected.get(id), row)) expected.put(id, row.json());
                });
                assertThat(read()).isEqualTo(expected);
                assertForm();
                now = now.plus(Duration.ofHours(5));
            }
            List<CatalogueRow> all =
                    expected.keySet().stream().map(CatalogueRow::removal).toList();
            writer.update(all, now);
            assertThat(read()).isEmpty();
            assertForm();
        }
    }

    private static boolean isSameArchive(String before, CatalogueRow row) {
        return before != null && before.contains(row.json().replaceAll(".*(archiveSha256\":\"[0-9a-f]{64}).*", "$1"));
    }

    @Test
    void shouldFillPagesOfModelsThatComeInOrder() throws Exception {
        List<CatalogueRow> rows = new ArrayList<>();
        for (int i = 0; i < 102; i++) rows.add(row(String.format("m%03d", i), i));
        CatalogueWriter.Result result = writer.update(rows);
        assertThat(result).isEqualTo(new CatalogueWriter.Result(102, 102, 0, 0));
        assertThat(CatalogueRoot.read(store).pages()).hasSize(10);
        assertForm();
    }

    @Test
    void shouldTouchOnlyWhatChanges() throws Exception {
        long[] requests = new long[2];
        for (int k = 0; k < 2; k++) {
            List<CatalogueRow> rows = new ArrayList<>();
            for (int i = 0; i < (k == 0 ? 50 : 2000); i++) rows.add(row(String.format("m%05d", i), i));
            writer.update(rows);
            store.reset();
            writer.update(List.of(row(k == 0 ? "m00033x" : "m01033x", 7)));
            // The root is found, read and written; a page is read and becomes two; what it was is noted.
            assertThat(store.counts()).containsOnly(Map.entry("find", 1), Map.entry("read", 2), Map.entry("put", 4));
            requests[k] = store.total();
        }
        assertThat(requests[1]).isEqualTo(requests[0]);
        store.reset();
        writer.update(List.of(row("m00033x", 7)));
        assertThat(store.counts()).as("nothing new").containsOnly(Map.entry("find", 1), Map.entry("read", 2));
    }

    @Test
    void shouldRemoveWhatWasReplacedADayAgo() throws Exception {
        List<CatalogueRow> rows = new ArrayList<>();
        for (int i = 0; i < 30; i++) rows.add(row(String.format("m%02d", i), i));
        writer.update(rows, now);
        Files.createDirectories(folder.resolve("m/m20"));
        String old = String.format("%064x", 20);
        for (String name : List.of(old + ".jsm", "manifest.json", "index.html")) writeOld("m/m20/" + name);
        List<String> before = files();
        writer.update(List.of(row("m20", 99)), now);
        assertThat(files()).containsAll(before);
        writer.update(List.of(CatalogueRow.removal("m05")), now.plus(Duration.ofHours(23)));
        assertThat(folder.resolve("m/m20/" + old + ".jsm")).exists();
        Files.createDirectories(folder.resolve("m/m05"));
        writeOld("m/m05/manifest.json");
        writer.update(List.of(), now.plus(Duration.ofHours(25)));
        assertThat(folder.resolve("m/m20/" + old + ".jsm")).doesNotExist();
        assertThat(folder.resolve("m/m20/manifest.json")).exists();
        assertThat(folder.resolve("m/m05/manifest.json")).exists();
        writer.update(List.of(), now.plus(Duration.ofHours(48)));
        assertThat(folder.resolve("m/m05/manifest.json")).doesNotExist();
        List<String> named = new ArrayList<>(List.of("index.json"));
        for (CatalogueRoot.Page page : CatalogueRoot.read(store).pages()) named.add(page.file());
        assertThat(files()).containsExactlyInAnyOrderElementsOf(named);
    }

    private void writeOld(String name) throws IOException {
        Path file = Files.writeString(folder.resolve(name), "{}");
        Files.setLastModifiedTime(file, FileTime.from(Instant.now().minus(Duration.ofDays(3))));
    }

    @Test
    void shouldKeepAnArchiveThatCameBack() throws Exception {
        Files.createDirectories(folder.resolve("m/a"));
        String hash = String.format("%064x", 1);
        Files.writeString(folder.resolve("m/a/" + hash + ".jsm"), "");
        Files.writeString(folder.resolve("m/a/manifest.json"), "{\"archiveSha256\":\"" + hash + "\"}");
        writer.update(List.of(row("a", 1)), now);
        writer.update(List.of(row("a", 2)), now);
        writer.update(List.of(row("a", 1)), now);
        writer.update(List.of(row("b", 1)), now.plus(Duration.ofDays(3)));
        assertThat(folder.resolve("m/a/" + hash + ".jsm")).exists();
    }

    @Test
    void shouldLoseNothingOfManyWriters() throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(4);
        try {
            List<Future<?>> all = new ArrayList<>();
            for (int i = 0; i < 4; i++) {
                String beginning = "w" + i + "-";
                all.add(threads.submit(() -> {
                    for (int k = 0; k < 12; k++)
                        writer.update(List.of(row(beginning + String.format("%02d", k), k)), now);
                    return null;
                }));
            }
            for (Future<?> one : all) one.get();
        } finally {
            threads.shutdownNow();
        }
        assertThat(read()).hasSize(48);
        assertForm();
        // A run goes through some lists only.
        for (int i = 0; i < 3; i++) writer.update(List.of(), now.plus(Duration.ofDays(2)));
        assertThat(files())
                .as("left over")
                .hasSize(1 + CatalogueRoot.read(store).pages().size());
    }

    @Test
    void shouldReadCataloguesOfEarlierVersions() throws Exception {
        Files.createDirectories(folder.resolve("m"));
        Files.writeString(
                folder.resolve("m/index.json"),
                "{\"total\": 2, \"next\": \"after-%E6%A4%85.json\", \"models\": ["
                        + row("椅", 1).json() + "]}");
        Files.writeString(
                folder.resolve("m/after-椅.json"), "{\"models\": [" + row("模", 2).json() + "]}");
        writer.update(List.of(row("a", 3)), now);
        assertThat(read()).containsOnlyKeys("a", "椅", "模");
        assertThat(files()).contains("after-椅.json");
        writer.update(List.of(row("b", 3)), now.plus(Duration.ofDays(2)));
        assertThat(files()).containsExactly("index.json");
    }

    @Test
    void shouldFindModelsByTheirIds() throws Exception {
        List<CatalogueRow> rows = new ArrayList<>();
        for (int i = 0; i < 57; i++) rows.add(row(String.format("m%02d", i), i));
        writer.update(rows);
        for (CatalogueRow row : rows)
            assertThat(new CatalogueReader(store).find(row.id())).isEqualTo(row);
        for (String id : List.of("a", "m", "m101", "z"))
            assertThat(new CatalogueReader(store).find(id)).isNull();
    }

    @Test
    void shouldRefuseWhatIsOutOfOrderOrNoCatalogue() throws Exception {
        assertThatThrownBy(() -> writer.update(List.of(row("b", 1), row("a", 1))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("sort them by ids");
        assertThatThrownBy(() -> writer.update(List.of(row("b", 1), row("b", 1))))
                .isInstanceOf(IllegalArgumentException.class);
        for (String content : List.of("", "no JSON", "[]", "{\"models\": [{\"name\": \"without id\"}]}")) {
            Files.createDirectories(folder.resolve("m"));
            Files.write(folder.resolve("m/index.json"), content.getBytes(UTF_8));
            assertThatThrownBy(() -> writer.update(List.of(row("a", 1))))
                    .hasMessageContaining("is no page of a catalogue");
            assertThat(folder.resolve("m/index.json")).hasContent(content);
        }
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve("m"))) {
            return files.filter(Files::isRegularFile)
                    .map(file -> file.getFileName().toString())
                    .sorted()
                    .toList();
        }
    }
}
