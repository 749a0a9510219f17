package org.jsmesh.site;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ModelPublisherTest {
    private static final Instant LONG_AGO = Instant.now().minus(Duration.ofDays(3));
    private static final byte[] NOTES = "{\"annotations\": []}".getBytes(UTF_8);

    private static EncodedArchive archive;

    @TempDir
    private Path folder;

    private WatchedStore store;

    @BeforeAll
    static void encode() {
        MeshBuilder tetrahedron = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})
                .faceWedges(new int[] {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2});
        archive = new MeshEncoder(EncoderSettings.defaults()).encode(tetrahedron.build(), ProgressListener.NONE);
    }

    @BeforeEach
    void open() {
        store = new WatchedStore(folder);
    }

    private static byte[] page(String script) {
        String head = "<head><meta charset=\"utf-8\"><meta name=\"description\" content=\"\">"
                + "<meta name=\"generator\" content=\"jSM\"><title>jSM</title></head>";
        return (head + "<body><noscript></noscript><script src=\"" + script + "\"></script></body>").getBytes(UTF_8);
    }

    private CatalogueRow publish(String name, byte[] notes) throws IOException {
        return new ModelPublisher(store, page("viewer/a.js"), null).publish("a", name, archive, notes);
    }

    private String hash() throws IOException {
        return CatalogueJson.archive(publish("A", null).json());
    }

    private Instant time(String name) throws IOException {
        return Files.getLastModifiedTime(folder.resolve("m/a/" + name)).toInstant();
    }

    private void age(String... names) throws IOException {
        for (String name : names) Files.setLastModifiedTime(folder.resolve("m/a/" + name), FileTime.from(LONG_AGO));
    }

    @Test
    void shouldWriteTheWholeArchive() throws Exception {
        assertThat(folder.resolve("m/a/" + hash() + ".jsm")).hasBinaryContent(archive.bytes());
        assertThat(store.log()).noneMatch(request -> request.startsWith("delete"));
    }

    @Test
    void shouldWriteNothingThatIsThere() throws Exception {
        hash();
        store.log().clear();
        hash();
        assertThat(store.log()).noneMatch(request -> request.startsWith("put") || request.startsWith("delete"));
    }

    @Test
    void shouldRemoveAnnotationsBehindTheManifestThatNamedThem() throws Exception {
        publish("A", NOTES);
        assertThat(folder.resolve("m/a/annotations.json")).hasBinaryContent(NOTES);
        store.log().clear();
        publish("A", null);
        assertThat(folder.resolve("m/a/annotations.json")).doesNotExist();
        assertThat(store.log()).containsSubsequence("put m/a/manifest.json", "delete m/a/annotations.json");
    }

    @Test
    void shouldRenewAManifestThatWouldNotGuardItsArchive() throws Exception {
        String archiveFile = hash() + ".jsm";
        age("manifest.json", archiveFile);
        hash();
        assertThat(time("manifest.json")).isAfter(LONG_AGO.plus(Duration.ofDays(2)));
        assertThat(time(archiveFile)).as("it is large").isBefore(LONG_AGO.plusSeconds(9));
    }

    @Test
    void shouldRenewAnArchiveThatNoManifestGuards() throws Exception {
        String archiveFile = hash() + ".jsm";
        age(archiveFile);
        Files.writeString(folder.resolve("m/a/manifest.json"), "{\"archiveSha256\":\"another\"}");
        hash();
        assertThat(time(archiveFile)).isAfter(LONG_AGO.plus(Duration.ofDays(2)));
    }

    @Test
    void shouldWriteAgainWhatWasRemovedMeanwhile() throws Exception {
        String archiveFile = hash() + ".jsm";
        age("manifest.json", archiveFile);
        store.before("find m/a/index.html", () -> {
            store.inner.delete("m/a/" + archiveFile);
            store.inner.delete("m/a/manifest.json");
        });
        hash();
        assertThat(folder.resolve("m/a/" + archiveFile)).exists();
        assertThat(folder.resolve("m/a/manifest.json")).exists();
    }

    @Test
    void shouldReplaceAManifestThatIsDamaged() throws Exception {
        hash();
        Files.writeString(folder.resolve("m/a/manifest.json"), "{\"half");
        hash();
        assertThat(folder.resolve("m/a/manifest.json")).content().contains(hash());
    }

    /** With one published model. */
    private StaticSite site(String script) throws IOException {
        Map<String, byte[]> files = Map.of("index.html", page(script), script, new byte[1]);
        return StaticSite.open(store, new TreeMap<>(files));
    }

    private void begin() throws IOException {
        new CatalogueWriter(store).update(List.of(publish("A", null)));
        try (StaticSite site = site("viewer/a.js")) {
            site.finish();
        }
        store.log().clear();
    }

    @Test
    void shouldWriteThePageBehindThoseOfModels() throws Exception {
        begin();
        try (StaticSite site = site("viewer/b.js")) {
            site.finish();
        }
        assertThat(store.log()).containsSubsequence("put viewer/b.js", "put m/a/index.html", "put index.html");
        assertThat(folder.resolve("m/a/index.html")).content().contains("viewer/b.js");
    }

    @Test
    void shouldNotReplaceAPageThatSomebodyElsePublishesMeanwhile() throws Exception {
        begin();
        store.before(
                "put m/a/index.html",
                () -> new ModelPublisher(store.inner, page("viewer/b.js"), null)
                        .publish("a", "newer name", archive, null));
        try (StaticSite site = site("viewer/b.js")) {
            site.finish();
        }
        assertThat(folder.resolve("m/a/index.html")).content().contains("newer name", "viewer/b.js");
    }
}
