package org.jsmesh.store.bucket;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.objects.ObjectKeys;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.store.ModelUnavailableException;

/**
 * The archives of a site that were used last, open by their headers. Whether one is still there is looked up once a
 * minute, so that what is withdrawn is not sent for long. Thread-safe.
 */
final class SiteArchives {
    private static final int MOST_OPEN = 512;
    private static final long SURE_NANOS = TimeUnit.SECONDS.toNanos(60);
    private static final long FAILURE_NANOS = TimeUnit.SECONDS.toNanos(1);

    /** Longer than requests wait, so that those who waited for the look are told what it found. */
    private static final long ABSENT_NANOS = TimeUnit.SECONDS.toNanos(5);

    private final ObjectStore store;
    private final Reads reads;
    private final BlockCache blocks;
    private final LongSupplier nanos;
    private final Map<String, Opened> opened = new LinkedHashMap<>(64, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Opened> eldest) {
            return size() > MOST_OPEN;
        }
    };

    private final class Opened {
        CompletableFuture<SiteArchive> archive; // null in it: there is none
        volatile long lookedNanos;

        boolean isGood() {
            if (!archive.isDone()) return true;
            long age = nanos.getAsLong() - lookedNanos;
            if (archive.isCompletedExceptionally()) return age < FAILURE_NANOS;
            SiteArchive there = archive.join();
            return there == null ? age < ABSENT_NANOS : age < SURE_NANOS && !there.isLost();
        }
    }

    SiteArchives(ObjectStore store, Reads reads, BlockCache blocks, LongSupplier nanos) {
        this.store = store;
        this.reads = reads;
        this.blocks = blocks;
        this.nanos = nanos;
    }

    /**
     * An archive by its key.
     *
     * @return completes with null when there is none, exceptionally with {@link ModelUnavailableException}
     */
    synchronized CompletableFuture<SiteArchive> open(String key, String sha256) {
        if (!ObjectKeys.isKey(key)) return CompletableFuture.completedFuture(null);
        Opened known = opened.get(key);
        if (known != null && known.isGood()) return known.archive;
        SiteArchive before = known == null || known.archive.isCompletedExceptionally() ? null : known.archive.join();
        Opened next = new Opened();
        next.archive = reads.begin(() -> look(key, sha256, before));
        next.archive.whenComplete((archive, failure) -> next.lookedNanos = nanos.getAsLong());
        opened.put(key, next);
        return next.archive;
    }

    /** {@return the archive if it was used a moment ago; otherwise null} */
    synchronized SiteArchive recent(String key) {
        Opened known = opened.get(key);
        boolean isThere = known != null && known.archive.isDone() && known.isGood();
        return isThere && !known.archive.isCompletedExceptionally() ? known.archive.join() : null;
    }

    private SiteArchive look(String key, String sha256, SiteArchive before) throws IOException {
        StoredObject object = store.find(key).orElse(null);
        if (object == null) return null;
        if (before != null && before.object().tag().equals(object.tag()) && !before.isLost()) return before;
        try {
            return SiteArchive.open(store, object, sha256, blocks);
        } catch (MalformedStreamException e) {
            throw ModelUnavailableException.ofModel(
                    "the archive of this model is damaged: " + e.getMessage(), "publish the model again", e);
        }
    }
}
