package org.jsmesh.store;

import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * Reads an archive a block at a time. Holds the archive open until it is closed. Not thread-safe: one reader serves one
 * answer.
 */
public final class ArchiveReader implements AutoCloseable {
    private final Archive archive;
    private ByteBuffer block = BlockBuffers.take();
    private long at = -1; // number of the block in the buffer

    /** @param archive held for this reader */
    ArchiveReader(Archive archive) {
        this.archive = archive;
    }

    /**
     * Some of the bytes from {@code offset} on, at least one. They stay as they are until the next call.
     *
     * @param offset of the first byte from the start of the file
     * @param length most bytes wanted, at least 1
     * @return a view of them, outside of the heap
     * @throws IllegalArgumentException when the range is not within the file
     * @throws IOException when the file cannot be read any more, or has changed since it was opened
     */
    public ByteBuffer next(long offset, long length) throws IOException {
        archive.check(offset, length);
        long number = offset / Archive.BLOCK_BYTES;
        if (number != at) {
            at = -1;
            archive.readBlock(number, block);
            at = number;
        }
        int start = (int) (offset % Archive.BLOCK_BYTES);
        return block.slice(start, (int) Math.min(length, block.limit() - start));
    }

    /** To be called when no view is in use any more. */
    @Override
    public void close() {
        if (block == null) return;
        BlockBuffers.give(block);
        release();
    }

    /** Closes while a view may be in use: its buffer is left to the collector. */
    public void abandon() {
        if (block != null) release();
    }

    private void release() {
        block = null;
        archive.release();
    }
}
