package org.jsmesh.store.bucket;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.jsmesh.store.ServedBytes;

/**
 * Reads an archive in a store, and a little ahead of what is sent. While a slow reader takes a portion nothing but that
 * portion is held for it: the block that it comes from may be forgotten, and is then read again.
 */
final class BlockReader implements ServedBytes {
    private static final int PORTION_BYTES = 1 << 15;

    /** Most blocks that are read before they are needed. */
    private static final int AHEAD = 3;

    private final SiteArchive archive;
    private final int blockBytes;
    private final ByteBuffer portion;
    private CompletableFuture<byte[]> wanted; // of the portion that comes next
    private int number = -1; // of its block
    private int ahead; // grows while somebody goes on reading

    /** @param length bytes that it is for */
    BlockReader(SiteArchive archive, long length) {
        this.archive = archive;
        blockBytes = archive.blockBytes();
        portion = ByteBuffer.allocate((int) Math.max(1, Math.min(PORTION_BYTES, length)));
    }

    @Override
    public CompletableFuture<?> ready(long offset, long length) {
        archive.check(offset, length);
        int block = (int) (offset / blockBytes);
        if (block != number) {
            if (number >= 0) ahead = Math.min(AHEAD, ahead + 1);
            int last = (int) Math.min((offset + length - 1) / blockBytes, (long) block + ahead);
            wanted = archive.block(block);
            for (int next = block + 1; next <= last; next++) archive.block(next);
            number = block;
        } else if (wanted == null) {
            wanted = archive.block(block);
        }
        return wanted;
    }

    @Override
    public ByteBuffer next(long offset, long length) throws IOException {
        byte[] block;
        try {
            block = wanted.join();
        } catch (CompletionException e) {
            if (e.getCause() instanceof IOException io) throw io;
            throw e;
        }
        wanted = null;
        int at = (int) (offset % blockBytes);
        int count = (int) Math.min(Math.min(length, portion.capacity()), block.length - at);
        // A copy, since a view would hold the whole block as long as the reader takes for a portion.
        return portion.clear().put(block, at, count).flip();
    }

    @Override
    public void close() {
        wanted = null;
    }

    @Override
    public void abandon() {
        wanted = null;
    }
}
