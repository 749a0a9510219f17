package org.jsmesh.site;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RemovedModelsTest {
    private static final List<String> FILES =
            List.of("index.html", "manifest.json", "abc.jsm", "abc/first.jsm", "other/poster.jpg");

    @TempDir
    private Path folder;

    private WatchedStore store;
    private CatalogueWriter writer;

    @BeforeEach
    void takeOff() throws IOException {
        store = new WatchedStore(folder);
        writer = new CatalogueWriter(store);
        for (String name : FILES) write(name, Instant.now().minus(Duration.ofHours(2)));
        writer.update(List.of(CatalogueWriterTest.row("a", 1), CatalogueWriterTest.row("ab", 1)));
        writer.update(List.of(CatalogueRow.removal("a")));
    }

    private void write(String name, Instant time) throws IOException {
        Path file = folder.resolve("m/a/" + name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, "{}");
        Files.setLastModifiedTime(file, FileTime.from(time));
    }

    @Test
    void shouldRemoveAllObjectsThatLeadToItFirst() throws Exception {
        Path other = Files.createDirectories(folder.resolve("m/ab")).resolve("manifest.json");
        Files.writeString(other, "{}");
        store.log().clear();
        assertThat(new RemovedModels(store, writer.time()).remove("a")).isTrue();
        assertThat(store.log().stream().filter(request -> request.startsWith("delete")))
                .hasSize(FILES.size())
                .startsWith("delete m/a/index.html", "delete m/a/manifest.json");
        assertThat(folder.resolve("m/a")).doesNotExist();
        assertThat(other).exists();
    }

    @Test
    void shouldKeepAModelThatIsAboutToComeBack() throws Exception {
        write("manifest.json", writer.time());
        // The catalogue is written again meanwhile, by somebody else.
        new CatalogueWriter(store).update(List.of(CatalogueWriterTest.row("c", 1)));
        assertThat(new RemovedModels(store, writer.time()).remove("a")).isFalse();
        for (String name : FILES) assertThat(folder.resolve("m/a/" + name)).exists();
    }

    @Test
    void shouldKeepAModelThatIsBack() throws Exception {
        Instant since = writer.time();
        writer.update(List.of(CatalogueWriterTest.row("a", 1)));
        assertThat(new RemovedModels(store, since).remove("a")).isFalse();
        assertThat(folder.resolve("m/a/abc.jsm")).exists();
    }
}
