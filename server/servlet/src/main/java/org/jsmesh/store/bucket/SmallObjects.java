package org.jsmesh.store.bucket;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.ByteBuffer;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
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

    /** What an object takes besides its bytes and its key. */
    private static final int OVERHEAD = 500;

    /** What a failure takes, with those that led to it. */
    private static final int FAILURE_BYTES = 1 << 13;

    /** A failure is told again so long, so that a store that is down is not asked by everybody. */
    private static final long FAILURE_NANOS = TimeUnit.SECONDS.toNanos(1);

    /** What was not there may come, even under a name that never has other content. */
    private static final long ABSENT_NANOS = TimeUnit.SECONDS.toNanos(5);

    /** In these the bytes that are being read are counted. */
    private static final int UNIT_BYTES = 1 << 10;

    private final ObjectStore store;
    private final Reads reads;
    private final long mostKept;
    private final LongSupplier nanos;
    private final Map<String, Kept> kept = new LinkedHashMap<>(64, 0.75f, true);
    private final int units;
    private final Semaphore reading; // units that may still be read at a time
    private long keptBytes;

    /** What is known of a key. */
    private final class Kept {
        CompletableFuture<SmallObject> look; // null in it: there is none
        SmallObject last;
        long lookedNanos;
        long countedBytes;

        boolean isGood(long freshNanos) {
            if (!look.isDone()) return true;
            long age = nanos.getAsLong() - lookedNanos;
            if (look.isCompletedExceptionally()) return age < FAILURE_NANOS;
            return age < (last == null ? Math.min(ABSENT_NANOS, freshNanos) : freshNanos);
        }
    }

    /** @param mostKept bytes that are kept, and as many that are being read; a larger object is read alone */
    SmallObjects(ObjectStore store, Reads reads, long mostKept, LongSupplier nanos) {
        this.store = store;
        this.reads = reads;
        this.mostKept = mostKept;
        this.nanos = nanos;
        units = (int) Math.min(MOST_BYTES / UNIT_BYTES, Math.max(1, mostKept / UNIT_BYTES));
        reading = new Semaphore(units, true);
    }

    /**
     * An object as it was no longer ago than a time.
     *
     * @param freshNanos that time
     * @return completes with null when there is none, exceptionally with {@link ModelUnavailableException}
     */
    synchronized CompletableFuture<SmallObject> get(String key, long freshNanos) {
        // Anybody can ask for anything: what no object is called is not worth keeping.
        if (!ObjectKeys.isKey(key)) return CompletableFuture.completedFuture(null);
        Kept one = kept.computeIfAbsent(key, k -> new Kept());
        if (one.look != null && one.isGood(freshNanos)) return one.look;
        SmallObject before = one.last;
        one.look = reads.begin(() -> look(key, before));
        CompletableFuture<SmallObject> looked = one.look;
        looked.whenComplete((object, failure) -> looked(key, one, object, failure));
        return looked;
    }

    private synchronized void looked(String key, Kept one, SmallObject object, Throwable failure) {
        one.lookedNanos = nanos.getAsLong();
        if (failure == null) one.last = object;
        if (kept.get(key) != one) return;
        long bytes = OVERHEAD + 2L * key.length();
        if (one.last != null) bytes += one.last.content().length;
        if (failure != null) bytes += FAILURE_BYTES;
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
        Optional<StoredObject> found = store.find(key);
        if (found.isEmpty()) return null;
        StoredObject object = found.get();
        if (before != null && before.object().tag().equals(object.tag())) return before;
        if (object.bytes() > MOST_BYTES)
            throw ModelUnavailableException.ofModel(
                    "the file " + key + " of the site has " + object.bytes() + " bytes",
                    "write the site anew with jsm encode --site",
                    null);
        int share = (int) Math.min(units, object.bytes() / UNIT_BYTES + 1);
        try {
            reading.acquire(share);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("the read of " + key + " was given up");
        }
        try {
            byte[] content = new byte[(int) object.bytes()];
            store.read(object, 0, ByteBuffer.wrap(content));
            return new SmallObject(object, content);
        } finally {
            reading.release(share);
        }
    }

    /** Bytes that entries in memory are counted as. */
    synchronized long keptBytes() {
        return keptBytes;
    }
}
