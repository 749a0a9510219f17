package org.jsmesh.store.bucket;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.jsmesh.objects.ObjectKeys;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.store.ModelUnavailableException;

/**
 * Small objects that were asked for last, and those that were found not to be there. One that is asked for again after
 * a while is looked at, and read again when it has changed. One look serves all who ask meanwhile. Thread-safe.
 */
final class SmallObjects {
    /** Larger ones are none that this project writes. */
    private static final int MOST_BYTES = 64 << 20;

    /** What an object takes besides its bytes. */
    private static final int OVERHEAD = 500;

    /** A failure is told again so long, so that a store that is down is not asked by everybody. */
    private static final long FAILURE_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final ObjectStore store;
    private final Reads reads;
    private final long mostKept;
    private final Map<String, Kept> kept = new LinkedHashMap<>(64, 0.75f, true);
    private long keptBytes;

    /** What is known of a key. */
    private static final class Kept {
        CompletableFuture<SmallObject> look; // null in it: there is none
        SmallObject last;
        long lookedNanos;
        long countedBytes;
    }

    /** @param mostKept bytes */
    SmallObjects(ObjectStore store, Reads reads, long mostKept) {
        this.store = store;
        this.reads = reads;
        this.mostKept = mostKept;
    }

    /**
     * An object as it was no longer ago than a time.
     *
     * @param freshNanos that time
     * @return completes with null when there is none, exceptionally with {@link ModelUnavailableException}
     */
    synchronized CompletableFuture<SmallObject> get(String key, long freshNanos) {
        Kept one = kept.computeIfAbsent(key, k -> new Kept());
        if (one.look != null) {
            if (!one.look.isDone()) return one.look;
            long age = System.nanoTime() - one.lookedNanos;
            if (age < (one.look.isCompletedExceptionally() ? FAILURE_NANOS : freshNanos)) return one.look;
        }
        SmallObject before = one.last;
        one.look = reads.begin(() -> look(key, before));
        CompletableFuture<SmallObject> looked = one.look;
        looked.whenComplete((object, failure) -> looked(key, one, object, failure));
        return looked;
    }

    private synchronized void looked(String key, Kept one, SmallObject object, Throwable failure) {
        one.lookedNanos = System.nanoTime();
        if (failure == null) one.last = object;
        if (kept.get(key) != one) return;
        long bytes = OVERHEAD + (one.last == null ? 0 : one.last.content().length);
        keptBytes += bytes - one.countedBytes;
        one.countedBytes = bytes;
        Iterator<Kept> eldest = kept.values().iterator();
        while (keptBytes > mostKept && eldest.hasNext()) {
            Kept candidate = eldest.next();
            if (!candidate.look.isDone()) continue;
            keptBytes -= candidate.countedBytes;
            eldest.remove();
        }
    }

    private SmallObject look(String key, SmallObject before) throws IOException {
        Optional<StoredObject> found;
        try {
            found = store.find(ObjectKeys.check(key));
        } catch (IllegalArgumentException e) {
            return null; // No object can have that key.
        }
        if (found.isEmpty()) return null;
        StoredObject object = found.get();
        if (before != null && before.object().tag().equals(object.tag())) return before;
        if (object.bytes() > MOST_BYTES)
            throw ModelUnavailableException.ofModel(
                    "the file " + key + " of the site has " + object.bytes() + " bytes",
                    "write the site anew with jsm encode --site",
                    null);
        byte[] content = new byte[(int) object.bytes()];
        store.read(object, 0, ByteBuffer.wrap(content));
        return new SmallObject(object, content);
    }
}
