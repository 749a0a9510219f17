package org.jsmesh.store;

import java.nio.ByteBuffer;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;

/** Buffers of one block, outside of the heap, kept for the next reader: making one costs more than filling it. */
final class BlockBuffers {
    private static final int MOST_KEPT = 256;

    private static final ConcurrentLinkedQueue<ByteBuffer> KEPT = new ConcurrentLinkedQueue<>();
    private static final AtomicInteger COUNT = new AtomicInteger();

    private BlockBuffers() {}

    static ByteBuffer take() {
        ByteBuffer kept = KEPT.poll();
        if (kept == null) return ByteBuffer.allocateDirect(Archive.BLOCK_BYTES);
        COUNT.decrementAndGet();
        return kept;
    }

    /** @param buffer that nobody reads or writes any more */
    static void give(ByteBuffer buffer) {
        if (COUNT.incrementAndGet() > MOST_KEPT) COUNT.decrementAndGet();
        else KEPT.add(buffer);
    }
}
