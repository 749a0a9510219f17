package org.jsmesh.s3;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.NoSuchFileException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.assertj.core.api.ThrowableAssert;
import org.jsmesh.objects.Condition;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every store keeps. */
abstract class ObjectStoreContract {
    private ObjectStore store;

    /** A store with nothing in it. */
    abstract ObjectStore empty() throws IOException;

    /** Looks and writes in one step, as services do. */
    StoredObject replace(ObjectStore in, Upload upload) throws IOException {
        return in.put(upload);
    }

    @BeforeEach
    void open() throws IOException {
        store = empty();
    }

    @AfterEach
    void close() throws IOException {
        store.close();
    }

    private StoredObject put(String key, String content) throws IOException {
        return store.put(Upload.of(key, ObjectContent.of(content.getBytes(UTF_8))));
    }

    private String get(String key) throws IOException {
        try (InputStream in = store.open(key)) {
            return new String(in.readAllBytes(), UTF_8);
        }
    }

    private List<String> keys(String prefix, String after, int most) throws IOException {
        List<String> keys = new ArrayList<>();
        store.list(prefix, after, object -> {
            keys.add(object.key());
            return keys.size() < most;
        });
        return keys;
    }

    @Test
    void shouldGiveBackWhatWasWritten() throws Exception {
        assertThat(store.find("m/a b/ü+%.json")).isEmpty();
        assertThatThrownBy(() -> store.open("m/a b/ü+%.json").close()).isInstanceOf(NoSuchFileException.class);
        StoredObject first = put("m/a b/ü+%.json", "one");
        assertThat(get("m/a b/ü+%.json")).isEqualTo("one");
        StoredObject found = store.find("m/a b/ü+%.json").orElseThrow();
        assertThat(found.tag()).isEqualTo(first.tag());
        assertThat(found.bytes()).isEqualTo(3);
        assertThat(found.modified())
                .isBetween(first.modified().minusSeconds(5), first.modified().plusSeconds(5));
        StoredObject second = put("m/a b/ü+%.json", "two");
        assertThat(second.tag()).isNotEqualTo(first.tag());
        assertThat(get("m/a b/ü+%.json")).isEqualTo("two");
        put("empty", "");
        assertThat(get("empty")).isEmpty();
        assertThat(store.find("m")).as("a folder").isEmpty();
        assertThat(store.find("empty/below")).as("below an object").isEmpty();
    }

    @Test
    void shouldReadPartsOfOneVersion() throws Exception {
        byte[] content = new byte[200_000];
        new Random(1).nextBytes(content);
        StoredObject object = store.put(Upload.of("a", ObjectContent.of(content)));
        for (ByteBuffer into : List.of(ByteBuffer.allocate(150_000), ByteBuffer.allocateDirect(150_000))) {
            into.position(7);
            store.read(object, 40_000, into);
            assertThat(into.hasRemaining()).isFalse();
            byte[] read = new byte[150_000 - 7];
            into.position(7).get(read);
            assertThat(read).isEqualTo(java.util.Arrays.copyOfRange(content, 40_000, 40_000 + read.length));
        }
        store.read(object, content.length, ByteBuffer.allocate(0));
        assertThatThrownBy(() -> store.read(object, content.length - 1, ByteBuffer.allocate(2)))
                .isInstanceOf(ObjectConflictException.class);
        store.put(Upload.of("a", ObjectContent.of(new byte[200_000])));
        assertThatThrownBy(() -> store.read(object, 0, ByteBuffer.allocate(1)))
                .isInstanceOf(ObjectConflictException.class)
                .hasMessageContaining("replaced or removed");
        store.delete("a");
        assertThatThrownBy(() -> store.read(object, 0, ByteBuffer.allocate(1)))
                .isInstanceOf(ObjectConflictException.class);
    }

    @Test
    void shouldWriteUnderConditionsOnly() throws Exception {
        Upload upload = Upload.of("c", ObjectContent.of("mine".getBytes(UTF_8)));
        assertConflict(upload.withCondition(new Condition("\"0123\"", false)));
        StoredObject first = store.put(upload.withCondition(Condition.ABSENT));
        assertConflict(upload.withCondition(Condition.ABSENT));
        StoredObject second = store.put(
                Upload.of("c", ObjectContent.of("more".getBytes(UTF_8))).withCondition(Condition.replacing(first)));
        assertConflict(upload.withCondition(Condition.replacing(first)));
        assertThat(get("c")).isEqualTo("more");
        store.put(upload.withCondition(Condition.replacing(second)));
        assertThat(get("c")).isEqualTo("mine");
        store.delete("c");
        assertConflict(upload.withCondition(Condition.replacing(second)));
        store.put(upload.withCondition(Condition.replacing(null)));
    }

    private void assertConflict(Upload upload) {
        assertThatThrownBy(() -> store.put(upload)).isInstanceOf(ObjectConflictException.class);
    }

    @Test
    void shouldLoseNoneOfManyChanges() throws Exception {
        put("n", "0");
        ExecutorService threads = Executors.newFixedThreadPool(2);
        try {
            List<Future<?>> all = new ArrayList<>();
            for (int i = 0; i < 2; i++)
                all.add(threads.submit(() -> {
                    for (int k = 0; k < 4; k++) increment();
                    return null;
                }));
            for (Future<?> one : all) one.get();
        } finally {
            threads.shutdownNow();
        }
        assertThat(get("n")).isEqualTo("8");
    }

    private void increment() throws IOException {
        while (true) {
            StoredObject before = store.find("n").orElseThrow();
            ByteBuffer text = ByteBuffer.allocate((int) before.bytes());
            try {
                store.read(before, 0, text);
                String next = String.valueOf(
                        Integer.parseInt(UTF_8.decode(text.flip()).toString()) + 1);
                Upload upload = Upload.of("n", ObjectContent.of(next.getBytes(UTF_8)));
                replace(store, upload.withCondition(Condition.replacing(before)));
                return;
            } catch (ObjectConflictException e) {
                Thread.onSpinWait(); // Somebody was quicker.
            }
        }
    }

    @Test
    void shouldListInOrderOfBytes() throws Exception {
        List<String> keys = List.of("a", "b-c", "b/a", "b/b/c", "b0", "c/d", "\u00fc");
        List<String> mixed = new ArrayList<>(keys);
        java.util.Collections.shuffle(mixed, new Random(3));
        for (String key : mixed) put(key, key);
        assertThat(keys("", "", 100)).isEqualTo(keys);
        assertThat(keys("b", "", 100)).containsExactly("b-c", "b/a", "b/b/c", "b0");
        assertThat(keys("b/", "", 100)).containsExactly("b/a", "b/b/c");
        assertThat(keys("b/b/c", "", 100)).containsExactly("b/b/c");
        assertThat(keys("", "b/a", 100)).isEqualTo(keys.subList(3, keys.size()));
        assertThat(keys("b", "b/a0", 100)).containsExactly("b/b/c", "b0");
        assertThat(keys("", "", 2)).containsExactly("a", "b-c");
        assertThat(keys("x", "", 100)).isEmpty();
    }

    @Test
    void shouldDeleteWithoutTrace() throws Exception {
        put("d/e/f", "x");
        put("d/g", "x");
        store.delete("d/e/f");
        store.delete("d/e/f");
        store.delete("d/e");
        store.delete("d");
        assertThat(keys("", "", 9)).containsExactly("d/g");
        put("d/e", "now an object");
        assertThat(get("d/e")).isEqualTo("now an object");
    }

    @Test
    void shouldTakeKeysOnlyThatAllStoresTake() {
        for (String key : List.of("", "/a", "a/", "a//b", "../a", "a/./b", "a\\b", "a\nb", "k".repeat(1025))) {
            assertRefused(key, () -> store.find(key));
            assertRefused(key, () -> store.open(key).close());
            assertRefused(key, () -> store.delete(key));
            assertRefused(key, () -> store.put(Upload.of(key, ObjectContent.of(new byte[1]))));
            assertRefused(
                    key, () -> store.read(new StoredObject(key, 1, "t", Instant.EPOCH), 0, ByteBuffer.allocate(1)));
            assertRefused(key, () -> store.signedAddress(key, Duration.ofHours(1)));
        }
    }

    private static void assertRefused(String key, ThrowableAssert.ThrowingCallable call) {
        assertThatThrownBy(call).as(key).isInstanceOf(IllegalArgumentException.class);
    }
}
