package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.jsmesh.servlet.http.Document;
import org.jsmesh.store.Archive;
import org.jsmesh.store.CountingEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.TestStores;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CatalogueTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    @TempDir
    private Path cache;

    private final CountingEncoder encoder = new CountingEncoder();
    private ModelStore store;
    private Catalogue catalogue;

    @BeforeEach
    void open() throws Exception {
        store = TestStores.open(folder, cache, encoder);
        catalogue = new Catalogue(store);
    }

    @AfterEach
    void close() {
        encoder.release();
        store.close();
    }

    private JsonNode page(String after) throws Exception {
        return JSON.readTree(catalogue.page(after).bytes());
    }

    private void make(int models) throws Exception {
        for (int i = 0; i < models; i++) Files.writeString(folder.resolve(String.format("m%05d.ply", i)), "x");
        store.list();
    }

    @Test
    void shouldGiveManyModelsInPagesThatLeadToEachOther() throws Exception {
        make(2500);
        TreeSet<String> ids = new TreeSet<>();
        List<Integer> sizes = new ArrayList<>();
        JsonNode page = page(null);
        JsonNode index = page.get("pages");
        assertThat(page.get("total").asInt()).isEqualTo(2500);
        while (true) {
            sizes.add(page.get("models").size());
            page.get("models").forEach(row -> ids.add(row.get("id").asText()));
            if (!page.has("next")) break;
            String next = page.get("next").asText();
            assertThat(next).startsWith("after-").endsWith(".json");
            page = page(next.substring("after-".length(), next.length() - ".json".length()));
        }
        assertThat(ids).hasSize(2500);
        assertThat(index).hasSize(sizes.size() - 1);
        for (int i = 0; i < index.size(); i++) {
            JsonNode row = index.get(i);
            assertThat(row.get(1).asInt()).isEqualTo(sizes.get(i + 1));
            String after = row.get(2).asText().replaceFirst("after-(.*)\\.json", "$1");
            assertThat(page(after).at("/models/0/id").asText())
                    .isEqualTo(row.get(0).asText());
        }
        assertThat(sizes).hasSizeBetween(3, 5).allMatch(size -> size <= 1000);
    }

    @Test
    void shouldHaveNoSecondPageOfAThousandModels() throws Exception {
        make(1001);
        assertThat(page(null).has("next")).isTrue();
        Files.delete(folder.resolve("m00500.ply"));
        store.list();
        assertThat(page(null).has("next")).isFalse();
        assertThat(page(null).get("models")).hasSize(1000);
    }

    @Test
    void shouldKeepAPageUntilAModelOfItChanges() throws Exception {
        make(1500);
        String second = next(page(null));
        Document first = catalogue.page(null);
        Document other = catalogue.page(second);
        assertThat(catalogue.page(null)).isSameAs(first);
        Archive archive = store.archive(store.find("m00001").orElseThrow()).get(30, TimeUnit.SECONDS);
        Await.until(
                "the model to be ready in the catalogue",
                () -> page(null).at("/models/1/archiveSha256").asText().equals(archive.sha256()));
        assertThat(catalogue.page(null)).isNotSameAs(first);
        assertThat(catalogue.page(second)).isSameAs(other);
    }

    private static String next(JsonNode page) {
        return page.get("next").asText().replaceFirst("after-(.*)\\.json", "$1");
    }

    @Test
    void shouldShowHowFarAnEncodingIs() throws Exception {
        make(1);
        encoder.hold();
        CompletableFuture<Archive> archive = store.archive(store.find("m00000").orElseThrow());
        Await.until(
                "the encoding to show",
                () -> page(null).at("/models/0/state").asText().equals("preparing"));
        encoder.release();
        archive.get(30, TimeUnit.SECONDS);
        Await.until(
                "the end to show",
                () -> page(null).at("/models/0/state").asText().equals("ready"));
    }

    @Test
    void shouldShowWhatComesAndGoesByItself() throws Exception {
        Files.writeString(folder.resolve("new.ply"), "x");
        Await.until("the new model", () -> page(null).get("total").asInt() == 1);
        Files.delete(folder.resolve("new.ply"));
        Await.until("its end", () -> page(null).get("total").asInt() == 0);
        assertThat(page(null).get("models")).isEmpty();
    }
}
