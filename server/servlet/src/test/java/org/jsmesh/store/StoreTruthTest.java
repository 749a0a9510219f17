package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.Comparator;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.sandbox.ModelEncoder;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is kept is what was encoded, whatever happens to files meanwhile. */
class StoreTruthTest {
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
    void shouldKeepAnArchiveUnderWhatWasReadAndNothingElse() throws Exception {
        Path file = Files.writeString(folder.resolve("chair.ply"), "first");
        encoder.hold();
        CompletableFuture<Archive> begun = store.archive(entry("chair"));
        encoder.awaitRunning(1);
        // It was hashed for the look into the cache, and is read only now.
        Files.writeString(file, "other");
        encoder.release();
        begun.get(30, TimeUnit.SECONDS);
        assertThat(bytes("chair")).isEqualTo(CountingEncoder.archiveOf("other"));
        Files.writeString(file, "first");
        assertThat(bytes("chair")).isEqualTo(CountingEncoder.archiveOf("first"));
        assertThat(encoder.begun()).isEqualTo(2);
    }

    @Test
    void shouldNoticeAFileThatIsPutInTheOthersPlaceWithItsSizeAndTime() throws Exception {
        Path file = Files.writeString(folder.resolve("chair.ply"), "one");
        FileTime time = FileTime.fromMillis(1_600_000_000_000L);
        Files.setLastModifiedTime(file, time);
        bytes("chair");
        Path other = Files.writeString(folder.resolve(".other"), "two");
        Files.setLastModifiedTime(other, time);
        Files.move(other, file, StandardCopyOption.REPLACE_EXISTING);
        assertThat(bytes("chair")).isEqualTo(CountingEncoder.archiveOf("two"));
    }

    @Test
    void shouldNoticeAChangeInTheInstantAfterItsReading() throws Exception {
        Path file = Files.writeString(folder.resolve("chair.ply"), "one");
        bytes("chair");
        FileTime time = Files.getLastModifiedTime(file);
        Files.writeString(file, "two");
        Files.setLastModifiedTime(file, time);
        assertThat(bytes("chair")).isEqualTo(CountingEncoder.archiveOf("two"));
    }

    @Test
    void shouldWatchCompanionsInSubFolders() throws Exception {
        Files.writeString(folder.resolve("chair.ply"), "chair");
        Path picture = Files.createDirectories(folder.resolve("pictures")).resolve("wood.png");
        encoder.referTo("pictures/wood.png");
        bytes("chair");
        assertThat(encoder.begun()).isEqualTo(1);
        Files.writeString(picture, "a picture that was missing");
        bytes("chair");
        assertThat(encoder.begun()).as("it came").isEqualTo(2);
        Files.writeString(picture, "another picture");
        bytes("chair");
        assertThat(encoder.begun()).as("it changed").isEqualTo(3);
        Files.move(picture, picture.resolveSibling("WOOD.png"));
        bytes("chair");
        assertThat(encoder.begun()).as("it has another name").isEqualTo(4);
        Files.delete(picture.resolveSibling("WOOD.png"));
        bytes("chair");
        assertThat(encoder.begun()).as("it is gone, as at first").isEqualTo(4);
    }

    @Test
    void shouldServeNoByteThatTheCacheHasLostOrChanged() throws Exception {
        Files.writeString(folder.resolve("chair.ply"), "chair");
        byte[] right = bytes("chair");
        Path kept = cache.resolve(archive("chair").sha256() + ".jsm");
        byte[] altered = right.clone();
        altered[right.length - 1] ^= 1;
        Files.write(kept, altered);
        try (ModelStore next = TestStores.open(folder, cache, encoder)) {
            Archive archive = next.archive(next.find("chair").orElseThrow()).get(30, TimeUnit.SECONDS);
            assertThat(archive.copy(0, right.length)).isEqualTo(right);
        }
        assertThat(encoder.begun()).isEqualTo(2);
    }

    @Test
    void shouldOpenAgainWhatWasWrittenInto() throws Exception {
        byte[] first = TestArchives.of(1, 500, 1500);
        byte[] second = TestArchives.of(2, 500, 1500);
        Path file = Files.write(folder.resolve("ready.jsm"), first);
        Archive open = archive("ready");
        FileTime time = Files.getLastModifiedTime(file);
        Files.write(file, second);
        Files.setLastModifiedTime(file, time);
        assertThatThrownBy(() -> open.copy(0, first.length)).isInstanceOf(IOException.class);
        assertThat(bytes("ready")).isEqualTo(second);
    }

    @Test
    void shouldTellThatAFileIsGone() throws Exception {
        Path file = Files.writeString(folder.resolve("chair.ply"), "chair");
        bytes("chair");
        ModelEntry entry = entry("chair");
        Files.delete(file);
        assertThatThrownBy(() -> store.archive(entry))
                .isInstanceOfSatisfying(
                        ModelUnavailableException.class,
                        e -> assertThat(e.isGone()).isTrue());
    }

    @Test
    void shouldComeToAnEndWhateverIsThrown() throws Exception {
        ModelEncoder failing = new ModelEncoder() {
            @Override
            public ModelInputs encode(Path model, Path archive, ProgressListener progress) {
                throw new InternalError("a fault occurred in an unsafe memory access operation");
            }
        };
        Files.writeString(folder.resolve("chair.ply"), "chair");
        try (ModelStore broken = TestStores.open(folder, Files.createDirectory(cache.resolve("b")), failing)) {
            CompletableFuture<Archive> archive =
                    broken.archive(broken.find("chair").orElseThrow());
            assertThatThrownBy(() -> archive.get(30, TimeUnit.SECONDS))
                    .isInstanceOf(ExecutionException.class)
                    .hasCauseInstanceOf(ModelUnavailableException.class);
        }
    }

    @Test
    void shouldGoOnWhenTheCacheIsEmptied() throws Exception {
        Files.writeString(folder.resolve("chair.ply"), "chair");
        Files.writeString(folder.resolve("table.ply"), "table");
        bytes("chair");
        try (Stream<Path> all = Files.walk(cache)) {
            for (Path file : all.sorted(Comparator.reverseOrder()).toList()) Files.delete(file);
        }
        assertThat(bytes("chair")).as("open").isEqualTo(CountingEncoder.archiveOf("chair"));
        assertThat(bytes("table")).isEqualTo(CountingEncoder.archiveOf("table"));
        assertThat(cache.resolve(archive("table").sha256() + ".jsm")).exists();
    }

    @Test
    void shouldRemoveWhatAKilledServerLeft() throws Exception {
        Path left = Files.createDirectories(cache.resolve(".work/of-a-killed-server"));
        Files.writeString(left.resolve("1.jsm"), "half");
        try (ModelStore next = TestStores.open(folder, cache, encoder)) {
            assertThat(left).doesNotExist();
            next.list();
        }
        store.close();
        assertThat(cache.resolve(".work")).isEmptyDirectory();
    }

    private ModelEntry entry(String id) throws IOException {
        store.list();
        return store.find(id).orElseThrow();
    }

    private Archive archive(String id) throws Exception {
        return store.archive(entry(id)).get(30, TimeUnit.SECONDS);
    }

    private byte[] bytes(String id) throws Exception {
        Archive archive = archive(id);
        return archive.copy(0, (int) archive.bytes());
    }
}
