package org.jsmesh.store.bucket;

import java.nio.ByteBuffer;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.jsmesh.objects.ObjectConflictException;
import org.jsmesh.objects.ObjectStore;

/** Blocks of archives that were used last. A block that is asked for is read once for all who ask. Thread-safe. */
final class BlockCache {
    /** Large enough that a request to the store costs little for each byte. */
    static final int BLOCK_BYTES = 1 << 18;

    private final int blockBytes;
    private final ObjectStore store;
    private final Reads reads;
    private final long mostBytes;
    private final Map<Place, Block> blocks = new LinkedHashMap<>(64, 0.75f, true);
    private final AtomicLong readBytes = new AtomicLong();
    private final AtomicInteger readers = new AtomicInteger();
    private long keptBytes;

    /** @param archive one object for each version that was opened, compared by identity */
    private record Place(SiteArchive archive, int block) {}

    private static final class Block {
        CompletableFuture<byte[]> bytes;
        int length;
    }

    /** @param mostBytes in memory, besides those that are being read and sent */
    BlockCache(ObjectStore store, Reads reads, long mostBytes, int blockBytes) {
        this.blockBytes = blockBytes;
        this.store = store;
        this.reads = reads;
        this.mostBytes = mostBytes;
    }

    /** Bytes of every block but the last one of an archive. */
    int blockBytes() {
        return blockBytes;
    }

    /** {@return completes exceptionally with a {@link org.jsmesh.store.ModelUnavailableException} alone} */
    synchronized CompletableFuture<byte[]> get(SiteArchive archive, int block) {
        Place place = new Place(archive, block);
        Block known = blocks.get(place);
        if (known != null) return known.bytes;
        Block begun = new Block();
        begun.bytes = read(archive, (long) block * blockBytes, archive.blockBytes(block));
        blocks.put(place, begun);
        begun.bytes.whenComplete((bytes, failure) -> came(place, begun, bytes));
        return begun.bytes;
    }

    /** {@return the same if it is here or on its way; otherwise null} */
    synchronized CompletableFuture<byte[]> known(SiteArchive archive, int block) {
        Block known = blocks.get(new Place(archive, block));
        return known == null ? null : known.bytes;
    }

    /** Reads bytes for one who asks, and keeps nothing. */
    CompletableFuture<byte[]> read(SiteArchive archive, long offset, int length) {
        return reads.begin(() -> {
            byte[] bytes = new byte[length];
            try {
                store.read(archive.object(), offset, ByteBuffer.wrap(bytes));
            } catch (ObjectConflictException e) {
                archive.lose();
                throw e;
            }
            readBytes.addAndGet(length);
            return bytes;
        });
    }

    /** Counts one who reads blocks one after another. */
    void enter() {
        readers.incrementAndGet();
    }

    void leave() {
        readers.decrementAndGet();
    }

    /** How many blocks there is room for by reader, besides the one that is being sent. */
    int room() {
        return (int) Math.min(Integer.MAX_VALUE, mostBytes / blockBytes / Math.max(1, readers.get()) - 1);
    }

    /** Keeps a block that was read on another way. */
    synchronized void put(SiteArchive archive, int block, byte[] bytes) {
        Place place = new Place(archive, block);
        Block whole = new Block();
        whole.bytes = CompletableFuture.completedFuture(bytes);
        readBytes.addAndGet(bytes.length);
        blocks.put(place, whole);
        came(place, whole, bytes);
    }

    private synchronized void came(Place place, Block block, byte[] bytes) {
        if (bytes == null) {
            blocks.remove(place, block);
            return;
        }
        block.length = bytes.length;
        keptBytes += bytes.length;
        Iterator<Map.Entry<Place, Block>> eldest = blocks.entrySet().iterator();
        while (keptBytes > mostBytes && eldest.hasNext()) {
            Block candidate = eldest.next().getValue();
            if (candidate.length == 0) continue;
            keptBytes -= candidate.length;
            eldest.remove();
        }
    }

    /** Bytes of archives that were read from the store since the start. */
    long readBytes() {
        return readBytes.get();
    }

    /** Bytes in memory. */
    synchronized long keptBytes() {
        return keptBytes;
    }
}
