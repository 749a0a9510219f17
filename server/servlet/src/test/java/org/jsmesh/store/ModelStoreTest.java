package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ModelStoreTest {
    @TempDir
    Path folder;

    @TempDir
    Path cache;

    private final CountingEncoder encoder = new CountingEncoder();
    private ModelStore store;

    @BeforeEach
    void openStore() throws IOException {
        store = TestStores.open(folder, cache, encoder);
    }

    @AfterEach
    void closeStore() {
        encoder.release();
        store.close();
    }

    @Test
    void shouldServeArchivesAsTheyAre() throws Exception {
        byte[] bytes = TestArchives.of(1, 500, 1500);
        Files.write(folder.resolve("ready.jsm"), bytes);
        Archive archive = archive("ready");
        assertThat(bytes(archive)).isEqualTo(bytes);
        assertThat(archive.sha256()).hasSize(64);
        assertThat(encoder.begun()).isZero();
    }

    @Test
    void shouldEncodeOnceForAllWhoWait() throws Exception {
        Files.writeString(folder.resolve("horse.ply"), "horse");
        encoder.hold();
        ModelEntry entry = entry("horse");
        List<CompletableFuture<Archive>> waiting = new ArrayList<>();
        for (int i = 0; i < 50; i++)
            waiting.add(CompletableFuture.supplyAsync(() -> request(entry)).thenCompose(a -> a));
        CompletableFuture<Void> all = CompletableFuture.allOf(waiting.toArray(new CompletableFuture<?>[0]));
        assertThat(all).isNotDone();
        encoder.release();
        all.get(30, TimeUnit.SECONDS);
        assertThat(encoder.begun()).isEqualTo(1);
        for (CompletableFuture<Archive> one : waiting)
            assertThat(one.join()).isSameAs(waiting.get(0).join());
        assertThat(bytes(waiting.get(0).join())).isEqualTo(CountingEncoder.archiveOf("horse"));
    }

    @Test
    void shouldEncodeDifferentModelsSideBySide() throws Exception {
        Files.writeString(folder.resolve("a.ply"), "a");
        Files.writeString(folder.resolve("b.ply"), "b");
        encoder.hold();
        CompletableFuture<Archive> a = store.archive(entry("a"));
        CompletableFuture<Archive> b = store.archive(entry("b"));
        encoder.awaitRunning(2);
        encoder.release();
        CompletableFuture.allOf(a, b).get(30, TimeUnit.SECONDS);
        assertThat(encoder.begun()).isEqualTo(2);
    }

    @Test
    void shouldKeepArchivesForTheNextStart() throws Exception {
        Files.writeString(folder.resolve("horse.ply"), "horse");
        String sha256 = archive("horse").sha256();
        try (ModelStore next = TestStores.open(folder, cache, encoder)) {
            Archive archive = next.archive(next.find("horse").orElseThrow()).get(30, TimeUnit.SECONDS);
            assertThat(archive.sha256()).isEqualTo(sha256);
        }
        assertThat(encoder.begun()).isEqualTo(1);
        assertThat(cache.resolve(sha256 + ".jsm")).exists();
    }

    @Test
    void shouldReplaceADamagedKeptArchive() throws Exception {
        Files.writeString(folder.resolve("horse.ply"), "horse");
        archive("horse");
        for (Path file : kept()) Files.write(file, new byte[100]);
        try (ModelStore next = TestStores.open(folder, cache, encoder)) {
            Archive archive = next.archive(next.find("horse").orElseThrow()).get(30, TimeUnit.SECONDS);
            assertThat(bytes(archive)).isEqualTo(CountingEncoder.archiveOf("horse"));
        }
        assertThat(encoder.begun()).isEqualTo(2);
    }

    @Test
    void shouldEncodeAnewWhenTheFileChanges() throws Exception {
        Path file = folder.resolve("horse.ply");
        Files.writeString(file, "horse");
        archive("horse");
        Files.writeString(file, "other horse");
        assertThat(bytes(archive("horse"))).isEqualTo(CountingEncoder.archiveOf("other horse"));
    }

    @Test
    void shouldEncodeAnewWhenAMaterialFileChanges() throws Exception {
        Files.writeString(folder.resolve("cube.obj"), "cube");
        encoder.referTo("cube.mtl");
        Path materials = folder.resolve("cube.mtl");
        Files.writeString(materials, "newmtl red");
        archive("cube");
        Files.setLastModifiedTime(materials, FileTime.fromMillis(1_000_000));
        archive("cube");
        assertThat(encoder.begun()).as("the same bytes give the same archive").isEqualTo(1);
        Files.writeString(materials, "newmtl blue");
        archive("cube");
        archive("cube");
        assertThat(encoder.begun()).isEqualTo(2);
    }

    @Test
    void shouldSayWhyAModelFailsAndServeTheOthers() throws Exception {
        Files.writeString(folder.resolve("empty.ply"), "bad");
        Files.writeString(folder.resolve("good.ply"), "good");
        assertThatThrownBy(() -> archive("empty")).isInstanceOfSatisfying(ModelUnavailableException.class, e -> {
            assertThat(e).hasMessageContaining("'empty'").hasMessageContaining("the mesh has no face");
            assertThat(e.remedy()).isNotBlank();
        });
        assertThat(bytes(archive("good"))).isEqualTo(CountingEncoder.archiveOf("good"));
        assertThatThrownBy(() -> archive("empty")).isInstanceOf(ModelUnavailableException.class);
        assertThat(encoder.begun()).as("a failure is remembered").isEqualTo(2);
        assertThat(store.list())
                .extracting(ModelStatus::state)
                .containsExactly(ModelStatus.State.FAILED, ModelStatus.State.READY);
        Files.writeString(folder.resolve("empty.ply"), "mended");
        assertThat(bytes(archive("empty"))).isEqualTo(CountingEncoder.archiveOf("mended"));
    }

    @Test
    void shouldKeepPathsAndMistakesToItself() throws Exception {
        Files.writeString(folder.resolve("odd.ply"), "broken");
        assertThatThrownBy(() -> archive("odd"))
                .isInstanceOf(ModelUnavailableException.class)
                .satisfies(e -> assertThat(e.getMessage())
                        .doesNotContain(folder.toString())
                        .doesNotContain("mistake"));
    }

    @Test
    void shouldRefuseATruncatedArchive() throws Exception {
        byte[] whole = TestArchives.of(1, 500, 1500);
        Files.write(folder.resolve("cut.jsm"), Arrays.copyOf(whole, 1999));
        assertThatThrownBy(() -> archive("cut"))
                .isInstanceOf(ModelUnavailableException.class)
                .hasMessageContaining("2000 bytes")
                .hasMessageContaining("1999");
    }

    @Test
    void shouldNoticeNewAndRemovedModels() throws Exception {
        assertThat(store.list()).isEmpty();
        Path file = folder.resolve("new.ply");
        Files.writeString(file, "new");
        assertThat(store.list()).extracting(s -> s.entry().id()).containsExactly("new");
        assertThat(store.list()).extracting(ModelStatus::state).containsExactly(ModelStatus.State.NEW);
        ModelEntry entry = entry("new");
        Files.delete(file);
        assertThat(store.list()).isEmpty();
        assertThatThrownBy(() -> store.archive(entry)).isInstanceOf(ModelUnavailableException.class);
    }

    @Test
    void shouldTellHowFarAnEncodingIs() throws Exception {
        Files.writeString(folder.resolve("slow.ply"), "slow");
        encoder.hold();
        CompletableFuture<Archive> archive = store.archive(entry("slow"));
        ModelStatus status = store.list().get(0);
        assertThat(status.state()).isEqualTo(ModelStatus.State.PREPARING);
        assertThat(status.stage()).isNotBlank();
        encoder.release();
        archive.get(30, TimeUnit.SECONDS);
        assertThat(store.list().get(0).state()).isEqualTo(ModelStatus.State.READY);
    }

    @Test
    void shouldCancelEncodingsWhenItCloses() throws Exception {
        Files.writeString(folder.resolve("slow.ply"), "slow");
        encoder.hold();
        CompletableFuture<Archive> archive = store.archive(entry("slow"));
        store.close();
        encoder.release();
        assertThatThrownBy(() -> archive.get(30, TimeUnit.SECONDS))
                .cause()
                .isInstanceOfSatisfying(ModelUnavailableException.class, e -> {
                    assertThat(e).hasMessage("the server is stopping");
                    assertThat(e.isPassing()).isTrue();
                });
        assertThat(kept()).isEmpty();
    }

    @Test
    void shouldRefuseACacheThatIsAFile() throws IOException {
        Path file = Files.createFile(cache.resolve("file"));
        for (Path bad : List.of(file, file.resolve("below")))
            assertThatThrownBy(() -> TestStores.open(folder, bad, encoder))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining(bad + ": cannot keep archives");
    }

    @Test
    void shouldRefuseAFolderThatIsNotThere() {
        assertThatThrownBy(() -> TestStores.open(folder.resolve("nowhere"), cache, encoder))
                .isInstanceOf(NoSuchFileException.class);
    }

    private List<Path> kept() throws IOException {
        try (Stream<Path> files = Files.list(cache)) {
            return files.filter(f -> f.toString().endsWith(".jsm")).toList();
        }
    }

    private ModelEntry entry(String id) throws IOException {
        store.list();
        return store.find(id).orElseThrow();
    }

    private CompletableFuture<Archive> request(ModelEntry entry) {
        try {
            return store.archive(entry);
        } catch (ModelUnavailableException e) {
            throw new CompletionException(e);
        }
    }

    private Archive archive(String id) throws Exception {
        try {
            return store.archive(entry(id)).get(30, TimeUnit.SECONDS);
        } catch (ExecutionException e) {
            throw (Exception) e.getCause();
        }
    }

    private static byte[] bytes(Archive archive) throws IOException {
        return archive.copy(0, (int) archive.bytes());
    }
}
