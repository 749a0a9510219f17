package org.jsmesh.store.bucket;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.store.ServedArchive;
import org.jsmesh.store.ServedBytes;

/**
 * An archive in a store, of which the header alone was read. Its hash is that of its name, which the one who wrote it
 * has made of its bytes. Every further byte is of the version that was opened. Thread-safe.
 */
final class SiteArchive implements ServedArchive {
    /** Bytes that the decoder is fed at a time. */
    private static final int FEED_BYTES = 1 << 13;

    private final StoredObject object;
    private final String sha256;
    private final ArchiveHeader header;
    private final BlockCache blocks;
    private final int blockBytes;
    private volatile boolean lost;

    private SiteArchive(StoredObject object, String sha256, ArchiveHeader header, BlockCache blocks) {
        this.object = object;
        this.sha256 = sha256;
        this.header = header;
        this.blocks = blocks;
        blockBytes = blocks.blockBytes();
    }

    /**
     * Reads the header.
     *
     * @throws MalformedStreamException when it is no archive, or its length does not agree with its index
     */
    static SiteArchive open(ObjectStore store, StoredObject object, String sha256, BlockCache blocks)
            throws IOException {
        int blockBytes = blocks.blockBytes();
        if ((object.bytes() - 1) / blockBytes >= Integer.MAX_VALUE)
            throw new MalformedStreamException(object.bytes(), "the archive is too large to be served");
        ArchiveDecoder decoder = new ArchiveDecoder();
        List<byte[]> first = new ArrayList<>();
        for (long at = 0; at < object.bytes() && decoder.header() == null; at += blockBytes) {
            byte[] block = new byte[(int) Math.min(blockBytes, object.bytes() - at)];
            store.read(object, at, ByteBuffer.wrap(block));
            for (int fed = 0; fed < block.length && decoder.header() == null; fed += FEED_BYTES)
                decoder.feed(block, fed, Math.min(FEED_BYTES, block.length - fed));
            first.add(block);
        }
        ArchiveHeader header = decoder.header();
        if (header == null) throw new MalformedStreamException(object.bytes(), "the file ends within its header");
        long claimed = header.batches().archiveBytes();
        if (claimed != object.bytes())
            throw new MalformedStreamException(
                    object.bytes(), "the index speaks of " + claimed + " bytes, the file has " + object.bytes());
        SiteArchive archive = new SiteArchive(object, sha256, header, blocks);
        // Whoever opens an archive asks for its first bytes next.
        for (int i = 0; i < first.size(); i++) blocks.put(archive, i, first.get(i));
        return archive;
    }

    /** Another version has its place, or none. */
    void lose() {
        lost = true;
    }

    /** Whether it must be opened anew. */
    boolean isLost() {
        return lost;
    }

    StoredObject object() {
        return object;
    }

    @Override
    public long bytes() {
        return object.bytes();
    }

    @Override
    public String sha256() {
        return sha256;
    }

    @Override
    public ArchiveHeader header() {
        return header;
    }

    /** Bytes of all blocks but the last one. */
    int blockBytes() {
        return blockBytes;
    }

    int blockBytes(int block) {
        return (int) Math.min(blockBytes, bytes() - (long) block * blockBytes);
    }

    CompletableFuture<byte[]> block(int block) {
        return blocks.get(this, block);
    }

    BlockCache blocks() {
        return blocks;
    }

    void check(long offset, long length) {
        if (offset < 0 || length < 0 || length > bytes() - offset)
            throw new IllegalArgumentException("bytes " + offset + " to " + (offset + length) + " of " + bytes());
    }

    @Override
    public ServedBytes reader(long length) {
        return new BlockReader(this, length);
    }

    @Override
    public CompletableFuture<byte[]> read(long offset, int length) {
        check(offset, length);
        byte[] copy = new byte[length];
        CompletableFuture<byte[]> all = CompletableFuture.completedFuture(copy);
        if (length == 0) return all;
        int last = (int) ((offset + length - 1) / blockBytes);
        for (int number = (int) (offset / blockBytes); number <= last; number++) {
            long start = (long) number * blockBytes;
            all = all.thenCombine(block(number), (into, block) -> {
                long from = Math.max(start, offset);
                long to = Math.min(start + block.length, offset + length);
                System.arraycopy(block, (int) (from - start), into, (int) (from - offset), (int) (to - from));
                return into;
            });
        }
        return all;
    }
}
