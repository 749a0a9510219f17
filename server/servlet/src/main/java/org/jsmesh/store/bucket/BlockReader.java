package org.jsmesh.store.bucket;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.jsmesh.store.ServedBytes;

/**
 * Reads an archive in a store, and a little ahead of what is sent, as far as there is room for that. While a slow
 * reader takes a portion nothing but that portion is held for it: the block that it comes from may be forgotten. The
 * rest of that is then read by portions, so that no byte is read often for one reader.
 */
final class BlockReader implements ServedBytes {
    private static final int PORTION_BYTES = 1 << 15;

    /** Most blocks that are read before they are needed. */
    private static final int AHEAD = 3;

    private final SiteArchive archive;
    private final BlockCache blocks;
    private final int blockBytes;
    private final ByteBuffer portion;
    private CompletableFuture<byte[]> wanted; // holds the portion that comes next
    private long wantedFrom; // offset of its first byte
    private int number = -1; // of the block that is being sent
    private int ahead; // grows while somebody goes on reading
    private boolean isOver;

    /** @param length bytes that it is for */
    BlockReader(SiteArchive archive, long length) {
        this.archive = archive;
        blocks = archive.blocks();
        blockBytes = archive.blockBytes();
        portion = ByteBuffer.allocate((int) Math.max(1, Math.min(PORTION_BYTES, length)));
        blocks.enter();
    }

    @Override
    public CompletableFuture<?> ready(long offset, long length) {
        archive.check(offset, length);
        int block = (int) (offset / blockBytes);
        if (block != number) {
            if (number >= 0) ahead = Math.min(AHEAD, ahead + 1);
            number = block;
            wantedFrom = (long) block * blockBytes;
            wanted = blocks.get(archive, block);
            long last = Math.min((offset + length - 1) / blockBytes, (long) block + Math.min(ahead, blocks.room()));
            for (int next = block + 1; next <= last; next++) blocks.get(archive, next);
        } else if (wanted == null || offset < wantedFrom) {
            wantedFrom = (long) block * blockBytes;
            wanted = blocks.known(archive, block);
            if (wanted == null) {
                wantedFrom = offset;
                long blockEnd = Math.min(archive.bytes(), (block + 1L) * blockBytes);
                int count = (int) Math.min(Math.min(length, portion.capacity()), blockEnd - offset);
                wanted = blocks.read(archive, offset, count);
            }
        }
        return wanted;
    }

    @Override
    public ByteBuffer next(long offset, long length) throws IOException {
        byte[] from;
        try {
            from = wanted.join();
        } catch (CompletionException e) {
            if (e.getCause() instanceof IOException io) throw io;
            throw e;
        }
        wanted = null;
        int at = (int) (offset - wantedFrom);
        int count = (int) Math.min(Math.min(length, portion.capacity()), from.length - at);
        // A copy, since a view would hold the whole block as long as the reader takes for a portion.
        return portion.clear().put(from, at, count).flip();
    }

    @Override
    public void close() {
        wanted = null;
        if (!isOver) blocks.leave();
        isOver = true;
    }

    @Override
    public void abandon() {
        close();
    }
}
