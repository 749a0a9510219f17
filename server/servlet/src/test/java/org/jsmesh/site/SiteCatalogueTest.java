package org.jsmesh.site;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jsmesh.store.ModelPage;
import org.jsmesh.store.ids.ModelIds;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SiteCatalogueTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    private final SortedMap<String, Path> models = new TreeMap<>();

    private void publish(String id) throws IOException {
        Path model = Files.createDirectory(folder.resolve(id));
        String hash = String.format("%064x", id.hashCode() & 0xffffffffL);
        Files.createFile(model.resolve(hash + ".jsm"));
        Files.writeString(
                model.resolve("manifest.json"),
                "{\"archiveUrl\": \"" + hash + ".jsm\", \"archiveSha256\": \"" + hash + "\"}");
        models.put(id, model);
    }

    private List<String> read() throws IOException {
        List<String> ids = new ArrayList<>();
        String name = "index.json";
        while (name != null) {
            JsonNode page = JSON.readTree(folder.resolve(name).toFile());
            assertThat(page.has("total")).isEqualTo(name.equals("index.json"));
            assertThat(page.get("models").size()).isLessThanOrEqualTo(ModelPage.MOST);
            page.get("models").forEach(row -> ids.add(row.get("id").asText()));
            String last = ids.isEmpty() ? "" : ids.get(ids.size() - 1);
            // What a host makes of the address is the name of a file.
            name = page.has("next") ? ModelPage.fileName(last) : null;
            if (name != null)
                assertThat(page.get("next").asText()).isEqualTo(ModelPage.fileName(ModelIds.segment(last)));
        }
        return ids;
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(Files::isRegularFile)
                    .map(file -> file.getFileName().toString())
                    .sorted()
                    .toList();
        }
    }

    @Test
    void shouldWritePagesThatNameEachOther() throws IOException {
        SiteCatalogue.write(folder, models);
        assertThat(read()).isEmpty();
        for (int i = 0; i < 999; i++) publish(String.format("m%04d", i));
        publish("模-obj-abcdef");
        SiteCatalogue.write(folder, models);
        assertThat(read()).containsExactlyElementsOf(models.keySet());
        assertThat(files()).containsExactly("index.json");
        publish("模-obj-abcdeg");
        SiteCatalogue.write(folder, models);
        assertThat(read()).containsExactlyElementsOf(models.keySet());
        assertThat(files()).containsExactly("after-模-obj-abcdef.json", "index.json");
        String modified = JSON.readTree(
                        folder.resolve("after-模-obj-abcdef.json").toFile())
                .at("/models/0/modified")
                .asText();
        assertThat(modified).endsWith("Z");

        // Whoever has read the first page goes on with the one it named.
        publish("a");
        SiteCatalogue.write(folder, models);
        assertThat(read()).containsExactlyElementsOf(models.keySet());
        assertThat(files()).containsExactly("after-m0998.json", "after-模-obj-abcdef.json", "index.json");
        SiteCatalogue.write(folder, models);
        assertThat(files()).containsExactly("after-m0998.json", "index.json");
    }
}
