package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.jsmesh.sandbox.EncodingFailure;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Nothing that a store keeps or lets wait grows without a limit. */
class StoreLimitsTest {
    /** What every test archive of the encoder has. */
    private static final int BYTES = 6600;

    @TempDir
    Path folder;

    @TempDir
    Path cache;

    private final CountingEncoder encoder = new CountingEncoder();
    private ModelStore store;

    @AfterEach
    void closeStore() {
        encoder.release();
        if (store != null) store.close();
    }

    private StoreSettings settings() {
        return TestStores.settings(folder, cache);
    }

    private void open(StoreSettings settings, String... models) throws IOException {
        for (String model : models) Files.writeString(folder.resolve(model + ".ply"), model);
        store = TestStores.open(settings, encoder);
    }

    @Test
    void shouldRemoveWhatWasNotUsedForLongest() throws Exception {
        open(settings().withCacheBytes(2 * BYTES + 100).withEncoders(1), "a", "b", "c", "d");
        for (String model : List.of("a", "b", "c", "d")) archive(model);
        Await.until("two archives in the cache", () -> kept().size() == 2);
        assertThat(archive("d")).isNotNull();
        assertThat(encoder.begun()).isEqualTo(4);
        assertThat(store.list()).extracting(ModelStatus::state).containsOnly(ModelStatus.State.READY);
        archive("a");
        assertThat(encoder.begun()).as("what went is encoded again").isEqualTo(5);
    }

    @Test
    void shouldNotRemoveWhatIsBeingSent() throws Exception {
        open(settings().withCacheBytes(BYTES).withEncoders(1), "a", "b", "c");
        Archive sent = archive("a");
        try (ArchiveReader reader = sent.reader(1)) {
            archive("b");
            archive("c");
            Await.until("b to go", () -> kept().size() == 2);
            assertThat(kept()).contains(cache.resolve(sent.sha256() + ".jsm"));
            assertThat(reader.next(BYTES - 10, 10).remaining()).isEqualTo(10);
        }
    }

    @Test
    void shouldCloseArchivesThatWereNotUsedForLongest() throws Exception {
        open(settings().withOpen(2), "a", "b", "c");
        Archive first = archive("a");
        archive("b");
        archive("c");
        Await.until("the first to be closed", first::isClosed);
        assertThat(store.status(entry("a")).state()).isEqualTo(ModelStatus.State.READY);
        assertThat(archive("a").copy(0, BYTES)).isEqualTo(CountingEncoder.archiveOf("a"));
        assertThat(encoder.begun()).isEqualTo(3);
    }

    @Test
    void shouldRefuseWishesBeyondTheQueueAndBeyondAShare() throws Exception {
        open(settings().withWaiting(3, 2).withEncoders(1), "a", "b", "c", "d");
        encoder.hold();
        store.archive(entry("a"), "greedy");
        store.archive(entry("b"), "greedy");
        assertThatThrownBy(() -> store.archive(entry("c"), "greedy"))
                .isInstanceOfSatisfying(ModelUnavailableException.class, e -> {
                    assertThat(e.isPassing()).isTrue();
                    assertThat(e.retrySeconds()).isPositive();
                    assertThat(e).hasMessageContaining("2 models that you asked for");
                });
        assertThat(store.archive(entry("b"), "greedy")).as("again").isNotNull();
        store.archive(entry("c"), "other");
        assertThatThrownBy(() -> store.archive(entry("d"), "third")).hasMessageContaining("too many models wait");
        encoder.release();
        Await.until("room for another", () -> !isRefused("d"));
    }

    @Test
    void shouldForgetWishesThatNobodyRenews() throws Exception {
        open(settings().withWaiting(2, 2).withEncoders(1).withWishMillis(200), "a", "b", "c");
        encoder.hold();
        store.archive(entry("a"), "first");
        encoder.awaitRunning(1);
        CompletableFuture<Archive> left = store.archive(entry("b"), "gone");
        Await.until("b to wait", () -> store.waitingEncodings() == 1);
        Await.until("room for a client that stays", () -> {
            try {
                store.archive(entry("c"), "staying");
                return true;
            } catch (ModelUnavailableException e) {
                return false;
            }
        });
        assertThatThrownBy(() -> left.get(30, TimeUnit.SECONDS)).hasMessageContaining("nobody waited");
        assertThat(store.status(entry("b")).state()).isEqualTo(ModelStatus.State.NEW);
        CompletableFuture<Archive> lasting = store.archive(entry("c"));
        encoder.release();
        assertThat(lasting.get(30, TimeUnit.SECONDS)).isNotNull();
        assertThat(archive("b")).as("asked for again").isNotNull();
    }

    private boolean isRefused(String id) throws IOException {
        try {
            store.archive(entry(id), "greedy");
            return false;
        } catch (ModelUnavailableException e) {
            return true;
        }
    }

    @Test
    void shouldSayThatTheDiskIsFullAndNotEncodeAgainAndAgain() throws Exception {
        Files.writeString(folder.resolve("a.ply"), "a");
        Files.write(folder.resolve("ready.jsm"), TestArchives.of(1, 500, 1500));
        int[] begun = {0};
        ModelEncoder full = (model, archive, progress) -> {
            begun[0]++;
            throw EncodingFailure.noRoom(new IOException("No space left on device"));
        };
        store = TestStores.open(settings(), full);
        for (int i = 0; i < 3; i++) {
            CompletableFuture<Archive> archive = store.archive(entry("a"));
            assertThatThrownBy(() -> archive.get(30, TimeUnit.SECONDS))
                    .isInstanceOf(ExecutionException.class)
                    .cause()
                    .isInstanceOfSatisfying(ModelUnavailableException.class, e -> {
                        assertThat(e.isPassing()).isTrue();
                        assertThat(e.retrySeconds()).isPositive();
                        assertThat(e).hasMessageContaining("no room");
                    });
        }
        assertThat(begun[0]).isEqualTo(1);
        assertThat(archive("ready").bytes()).as("what is there is served").isEqualTo(2000);
    }

    private List<Path> kept() throws IOException {
        try (Stream<Path> files = Files.list(cache)) {
            return files.filter(f -> f.toString().endsWith(".jsm")).toList();
        }
    }

    private ModelEntry entry(String id) throws IOException {
        return store.find(id).orElseThrow();
    }

    private Archive archive(String id) throws Exception {
        return store.archive(entry(id)).get(30, TimeUnit.SECONDS);
    }
}
