package org.jsmesh.site;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CleanUpTest {
    private static final String HASH = String.format("%064x", 1);
    private static final List<String> FILES =
            List.of("index.html", "manifest.json", HASH + ".jsm", HASH + "/first.jsm", HASH + "/poster.jpg");

    @TempDir
    private Path folder;

    private WatchedStore store;
    private CatalogueWriter writer;
    private final Instant now = Instant.now();
    private final Instant nextDay = now.plus(Duration.ofHours(25));

    @BeforeEach
    void open() {
        store = new WatchedStore(folder);
        writer = new CatalogueWriter(store);
    }

    private void write(String name, Instant time) throws IOException {
        Path file = folder.resolve("m/a/" + name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, name.equals("manifest.json") ? "{\"archiveSha256\":\"" + HASH + "\"}" : "");
        Files.setLastModifiedTime(file, FileTime.from(time));
    }

    /** A model that was published days ago and has just been taken off. */
    private void removeModel() throws IOException {
        for (String name : FILES) write(name, now.minus(Duration.ofDays(3)));
        writer.update(List.of(CatalogueWriterTest.row("a", 1), CatalogueWriterTest.row("b", 2)), now);
        writer.update(List.of(CatalogueRow.removal("a")), now);
    }

    private List<String> there() {
        return FILES.stream()
                .filter(name -> Files.exists(folder.resolve("m/a/" + name)))
                .toList();
    }

    @Test
    void shouldRemoveAModelThatWasTakenOff() throws Exception {
        removeModel();
        assertThat(there()).isEqualTo(FILES);
        writer.update(List.of(), nextDay);
        assertThat(folder.resolve("m/a")).doesNotExist();
        assertThat(Files.readString(folder.resolve("m/index.json"))).doesNotContain("superseded");
    }

    @Test
    void shouldKeepWhatAWriterWithASlowClockHasJustReplaced() throws Exception {
        for (String name : FILES) write(name, now.minus(Duration.ofDays(3)));
        writer.update(List.of(CatalogueWriterTest.row("a", 1)), now);
        writer.update(List.of(CatalogueRow.removal("a")), now.minus(Duration.ofHours(30)));
        writer.update(List.of(CatalogueWriterTest.row("b", 2)), now);
        assertThat(there()).isEqualTo(FILES);
        assertThat(CatalogueRoot.read(store).superseded()).isNotEmpty();
    }

    @Test
    void shouldKeepAModelThatComesBackByTheSameUpdate() throws Exception {
        removeModel();
        writer.update(List.of(CatalogueWriterTest.row("a", 1)), nextDay);
        assertThat(there()).isEqualTo(FILES);
        assertThat(new CatalogueReader(store).find("a")).isNotNull();
    }

    @Test
    void shouldKeepAModelThatIsAboutToComeBack() throws Exception {
        removeModel();
        write("manifest.json", nextDay);
        writer.update(List.of(CatalogueWriterTest.row("c", 1)), nextDay);
        assertThat(there()).isEqualTo(FILES);
    }

    @Test
    void shouldKeepAnArchiveOfWhichTheManifestIsToBeWritten() throws Exception {
        removeModel();
        List<String> back = List.of(HASH + ".jsm", HASH + "/first.jsm");
        for (String name : back) write(name, nextDay);
        writer.update(List.of(), nextDay);
        assertThat(there()).containsExactlyInAnyOrderElementsOf(back);
    }

    @Test
    void shouldRemoveTheArchiveBeforeOfAModelThatCameBackWithAnother() throws Exception {
        removeModel();
        Files.writeString(folder.resolve("m/a/manifest.json"), "{\"archiveSha256\":\"another\"}");
        writer.update(List.of(CatalogueWriterTest.row("a", 9)), nextDay);
        assertThat(there()).containsExactly("index.html", "manifest.json");
    }

    @Test
    void shouldKeepAnArchiveThatWasWrittenAgainSinceItWasReplaced() throws Exception {
        for (String name : FILES) write(name, now.minus(Duration.ofDays(3)));
        Files.writeString(folder.resolve("m/a/manifest.json"), "{\"archiveSha256\":\"another\"}");
        writer.update(List.of(CatalogueWriterTest.row("a", 1)), now);
        writer.update(List.of(CatalogueWriterTest.row("a", 2)), now);
        write(HASH + ".jsm", nextDay);
        writer.update(List.of(), nextDay);
        assertThat(there()).containsExactly("index.html", "manifest.json", HASH + ".jsm");
    }

    @Test
    void shouldRemoveNothingBeforeTheChangesAreMade() throws Exception {
        removeModel();
        store.log().clear();
        // Somebody else adds a model meanwhile, so that the first try fails.
        store.before(
                "put m/index.json",
                () -> new CatalogueWriter(store.inner).update(List.of(CatalogueWriterTest.row("other", 1)), now));
        writer.update(List.of(CatalogueWriterTest.row("c", 1)), nextDay);
        List<String> requests = new ArrayList<>(store.log());
        int second = requests.lastIndexOf("put m/index.json");
        List<String> before = requests.subList(0, requests.subList(0, second).lastIndexOf("put m/index.json"));
        assertThat(before).contains("put m/index.json").noneMatch(request -> request.startsWith("delete"));
        assertThat(requests).contains("delete m/a/manifest.json");
        assertThat(new CatalogueReader(store).total()).isEqualTo(3);
    }

    @Test
    void shouldDropTheListsThoughOthersWriteMeanwhile() throws Exception {
        removeModel();
        store.before(
                "delete m/a/manifest.json",
                () -> new CatalogueWriter(store.inner).update(List.of(CatalogueWriterTest.row("other", 1)), now));
        writer.update(List.of(), nextDay);
        assertThat(CatalogueRoot.read(store).superseded()).isEmpty();
        assertThat(new CatalogueReader(store).find("other")).isNotNull();
        assertThat(folder.resolve("m/a")).doesNotExist();
    }

    @Test
    void shouldKeepAListWithoutATime() throws Exception {
        Files.createDirectories(folder.resolve("m"));
        Files.writeString(
                folder.resolve("m/index.json"),
                "{\"total\":0,\"models\":[],\"superseded\":[[\"yesterday\",\"superseded-x.json\"]]}");
        writer.update(List.of(CatalogueWriterTest.row("a", 1)), nextDay);
        assertThat(CatalogueRoot.read(store).superseded())
                .containsExactly(new CatalogueRoot.Old("yesterday", "superseded-x.json"));
    }

    @Test
    void shouldReadACatalogueThatIsReplacedWhileItIsRead() throws Exception {
        writer.update(List.of(CatalogueWriterTest.row("a", 1)), now);
        store.before(
                "read m/index.json",
                () -> new CatalogueWriter(store.inner).update(List.of(CatalogueWriterTest.row("b", 1)), now));
        assertThat(new CatalogueReader(store).total()).isEqualTo(2);
        store.before(
                "read m/index.json",
                () -> new CatalogueWriter(store.inner).update(List.of(CatalogueWriterTest.row("c", 1)), now));
        assertThat(writer.update(List.of(CatalogueWriterTest.row("d", 1)), now).total())
                .isEqualTo(4);
    }
}
