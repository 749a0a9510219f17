package org.jsmesh.store;

import java.nio.ByteBuffer;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Buffers outside of the heap, kept for the next reader: making one costs more than filling it. Large ones make long
 * answers cheap, but slow readers hold what they are given, so there are few of these; small ones hold a block, and
 * everybody gets one.
 */
final class BlockBuffers {
    private static final int LARGE_BLOCKS = 8;
    private static final int MOST_LARGE = 64;
    private static final int MOST_SMALL_KEPT = 256;

    private static final Pool SMALL = new Pool(Archive.BLOCK_BYTES, Integer.MAX_VALUE, MOST_SMALL_KEPT);
    private static final Pool LARGE = new Pool(LARGE_BLOCKS * Archive.BLOCK_BYTES, MOST_LARGE, MOST_LARGE);

    private BlockBuffers() {}

    /**
     * A buffer of one block or more.
     *
     * @param length of the answer that it is for
     */
    static ByteBuffer take(long length) {
        ByteBuffer large = length > 2L * Archive.BLOCK_BYTES ? LARGE.take() : null;
        return large == null ? SMALL.take() : large;
    }

    /** @param buffer that nobody reads or writes any more */
    static void give(ByteBuffer buffer) {
        pool(buffer).give(buffer);
    }

    /** Leaves a buffer to the collector, because somebody may still look at it. */
    static void abandon(ByteBuffer buffer) {
        pool(buffer).inUse.decrementAndGet();
    }

    private static Pool pool(ByteBuffer buffer) {
        return buffer.capacity() == Archive.BLOCK_BYTES ? SMALL : LARGE;
    }

    /** Buffers of one size. */
    private static final class Pool {
        private final int bytes;
        private final int most;
        private final int mostKept;
        private final ConcurrentLinkedQueue<ByteBuffer> kept = new ConcurrentLinkedQueue<>();
        private final AtomicInteger keptCount = new AtomicInteger();
        private final AtomicInteger inUse = new AtomicInteger();

        Pool(int bytes, int most, int mostKept) {
            this.bytes = bytes;
            this.most = most;
            this.mostKept = mostKept;
        }

        /** Null when too many are in use. */
        ByteBuffer take() {
            if (inUse.incrementAndGet() > most) {
                inUse.decrementAndGet();
                return null;
            }
            ByteBuffer free = kept.poll();
            if (free == null) return ByteBuffer.allocateDirect(bytes);
            keptCount.decrementAndGet();
            return free;
        }

        void give(ByteBuffer buffer) {
            inUse.decrementAndGet();
            if (keptCount.incrementAndGet() > mostKept) keptCount.decrementAndGet();
            else kept.add(buffer);
        }
    }
}
