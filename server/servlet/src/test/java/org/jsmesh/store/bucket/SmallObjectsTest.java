package org.jsmesh.store.bucket;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.jsmesh.objects.FolderObjectStore;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(60)
class SmallObjectsTest {
    private static final long EVER = Long.MAX_VALUE;

    @TempDir
    private Path folder;

    private final AtomicLong nanos = new AtomicLong();
    private final Reads reads = new Reads("s3://bucket", 30_000);
    private FaultyStore store;

    @AfterEach
    void stop() {
        reads.close();
    }

    private SmallObjects objects(long mostKept) {
        store = new FaultyStore(new FolderObjectStore(folder));
        return new SmallObjects(store, reads, mostKept, nanos::get);
    }

    private void write(String key, int bytes) throws Exception {
        Files.write(folder.resolve(key), new byte[bytes]);
    }

    @Test
    void shouldForgetWhatWasUsedLongestAgo() throws Exception {
        for (String key : List.of("a", "b", "c", "d")) write(key, 1000);
        SmallObjects objects = objects(5000);
        for (String key : List.of("a", "b", "c", "a", "d"))
            assertThat(objects.get(key, EVER).join().content()).hasSize(1000);
        assertThat(store.reads).hasValue(4);
        assertThat(objects.keptBytes()).isBetween(3000L, 5000L);
        objects.get("a", EVER).join();
        assertThat(store.finds).as("the one that was used again is kept").hasValue(4);
        objects.get("b", EVER).join();
        assertThat(store.finds).hasValue(5);
    }

    @Test
    void shouldReadAgainWhatHasChangedAlone() throws Exception {
        write("a", 10);
        SmallObjects objects = objects(5000);
        SmallObject first = objects.get("a", 100).join();
        nanos.set(99);
        assertThat(objects.get("a", 100).join()).isSameAs(first);
        assertThat(store.finds).hasValue(1);
        nanos.set(100);
        assertThat(objects.get("a", 100).join()).isSameAs(first);
        assertThat(store.finds).hasValue(2);
        assertThat(store.reads).hasValue(1);
        write("a", 20);
        nanos.set(300);
        assertThat(objects.get("a", 100).join().content()).hasSize(20);
    }

    @Test
    void shouldFindWhatHasComeAlsoUnderANameThatNeverChanges() throws Exception {
        SmallObjects objects = objects(5000);
        assertThat(objects.get("page", EVER).join()).isNull();
        write("page", 10);
        nanos.set(TimeUnit.SECONDS.toNanos(4));
        assertThat(objects.get("page", EVER).join()).isNull();
        nanos.set(TimeUnit.SECONDS.toNanos(5));
        assertThat(objects.get("page", EVER).join().content()).hasSize(10);
    }

    @Test
    void shouldKeepNothingOfKeysThatNoObjectHas() {
        SmallObjects objects = objects(5000);
        for (String key : List.of("m/" + "x".repeat(8192), "m//x", "m/../x"))
            assertThat(objects.get(key, EVER).join()).isNull();
        assertThat(objects.keptBytes()).isZero();
        assertThat(store.finds).hasValue(0);
    }

    @Test
    void shouldCountWhatAbsentOnesTake() {
        SmallObjects objects = objects(100_000);
        for (int i = 0; i < 200; i++)
            assertThat(objects.get("x".repeat(100) + i, EVER).join()).isNull();
        assertThat(objects.keptBytes()).isBetween(90_000L, 100_000L);
    }

    @Test
    void shouldReadNoMoreAtATimeThanItKeeps() throws Exception {
        AtomicInteger now = new AtomicInteger();
        AtomicInteger most = new AtomicInteger();
        SmallObjects objects = objects(8 << 10);
        store.besideReading = () -> {
            most.accumulateAndGet(now.incrementAndGet(), Math::max);
            try {
                Thread.sleep(20);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            now.decrementAndGet();
        };
        List<CompletableFuture<SmallObject>> asked = new ArrayList<>();
        for (int i = 0; i < 8; i++) write("o" + i, i == 0 ? 20_000 : 3 << 10);
        for (int i = 0; i < 8; i++) asked.add(objects.get("o" + i, EVER));
        for (CompletableFuture<SmallObject> one : asked) assertThat(one.join()).isNotNull();
        assertThat(most.get()).isBetween(1, 2);
    }
}
