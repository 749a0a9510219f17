package org.jsmesh.store;

import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * Reads an archive some blocks at a time. Holds the archive open until it is closed. Not thread-safe: one reader serves
 * one answer.
 */
public final class ArchiveReader implements ServedBytes {
    private final Archive archive;
    private ByteBuffer blocks;
    private long start; // place in the file of the first byte in the buffer
    private long end; // and of the byte after the last one

    /**
     * @param archive held for this reader
     * @param length bytes that it is for
     */
    ArchiveReader(Archive archive, long length) {
        this.archive = archive;
        blocks = BlockBuffers.take(length);
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
    @Override
    public ByteBuffer next(long offset, long length) throws IOException {
        archive.check(offset, length);
        if (offset < start || offset >= end) {
            start = end = 0;
            long first = offset / Archive.BLOCK_BYTES;
            archive.readBlocks(first, (offset + length - 1) / Archive.BLOCK_BYTES, blocks);
            start = first * Archive.BLOCK_BYTES;
            end = start + blocks.limit();
        }
        return blocks.slice((int) (offset - start), (int) Math.min(length, end - offset));
    }

    /** To be called when no view is in use any more. */
    @Override
    public void close() {
        if (blocks == null) return;
        BlockBuffers.give(blocks);
        release();
    }

    /** Closes while a view may be in use: its buffer is left to the collector. */
    @Override
    public void abandon() {
        if (blocks == null) return;
        BlockBuffers.abandon(blocks);
        release();
    }

    private void release() {
        blocks = null;
        archive.release();
    }
}
