package org.jsmesh.store;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.concurrent.CompletableFuture;
import java.util.zip.CRC32C;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Sizes;

/**
 * An archive file that is open for reading, and its header. Opening reads the whole file for its hash and keeps a
 * checksum of every block. Every block is checked when it is read again, so nothing but the bytes that were hashed is
 * ever given, even if somebody writes into the file or cuts it. Nothing is mapped: a file that is removed takes no disk
 * after {@link #close}. Thread-safe.
 */
public final class Archive implements ServedArchive, AutoCloseable {
    /** Large enough to cost little for each byte, and small enough to hold one for every slow reader. */
    static final int BLOCK_BYTES = 1 << 15;

    private final FileChannel channel;
    private final long bytes;
    private final int[] sums;
    private final String sha256;
    private final ArchiveHeader header;
    private int holders = 1;
    private boolean closed;
    private volatile boolean broken;

    private Archive(FileChannel channel, HeaderReader reader) throws IOException {
        this.channel = channel;
        bytes = channel.size();
        long blocks = (bytes + BLOCK_BYTES - 1) / BLOCK_BYTES;
        if (blocks > Sizes.MOST)
            throw new MalformedStreamException(bytes, "an archive of " + bytes + " bytes is too large to be served");
        sums = new int[(int) blocks];
        sha256 = hash();
        header = reader.read(this);
        long claimed = header.batches().archiveBytes();
        if (claimed != bytes)
            throw new MalformedStreamException(
                    bytes, "the index speaks of " + claimed + " bytes, the file has " + bytes);
    }

    /**
     * Opens the file, reads its header and hashes it.
     *
     * @param file a whole archive, of any size; it may be replaced or removed afterwards
     * @return the archive, to be closed by the caller
     * @throws MalformedStreamException when it is no archive, or its length does not agree with its index
     * @throws IOException when it cannot be read
     */
    public static Archive open(Path file) throws IOException {
        return open(file, HeaderReader.DECODER);
    }

    static Archive open(Path file, HeaderReader reader) throws IOException {
        FileChannel channel = FileChannel.open(file, StandardOpenOption.READ);
        try {
            return new Archive(channel, reader);
        } catch (Throwable e) {
            channel.close();
            throw e;
        }
    }

    /** {@return the size of the file} */
    @Override
    public long bytes() {
        return bytes;
    }

    /** {@return the SHA-256 of the file's bytes, in lower-case hexadecimal} */
    @Override
    public String sha256() {
        return sha256;
    }

    /** {@return what the archive says of itself} */
    @Override
    public ArchiveHeader header() {
        return header;
    }

    /**
     * Begins to read. The archive stays open until the reader is closed.
     *
     * @param length bytes that are to be read, as far as that is known
     * @return a reader; null when the archive was closed
     */
    @Override
    public ArchiveReader reader(long length) {
        return hold() ? new ArchiveReader(this, length) : null;
    }

    /**
     * A copy of some bytes.
     *
     * @param offset of the first byte from the start of the file
     * @param length number of bytes
     * @return the bytes
     * @throws IllegalArgumentException when the range is not within the file
     * @throws IOException when the archive was closed, the file cannot be read any more, or has changed since it was
     *     opened
     */
    public byte[] copy(long offset, int length) throws IOException {
        check(offset, length);
        byte[] copy = new byte[length];
        try (ArchiveReader reader = reader(length)) {
            if (reader == null) throw new IOException("the archive was closed");
            for (int at = 0; at < length; ) {
                ByteBuffer portion = reader.next(offset + at, length - at);
                int count = portion.remaining();
                portion.get(copy, at, count);
                at += count;
            }
        }
        return copy;
    }

    @Override
    public CompletableFuture<byte[]> read(long offset, int length) {
        try {
            return CompletableFuture.completedFuture(copy(offset, length));
        } catch (IOException e) {
            return CompletableFuture.failedFuture(ModelUnavailableException.passing(
                    "the archive of this model was written into or closed while it was read", "ask again", e));
        }
    }

    void check(long offset, long length) {
        if (offset < 0 || length < 0 || offset + length > bytes)
            throw new IllegalArgumentException("bytes " + offset + " to " + (offset + length) + " of " + bytes);
    }

    /**
     * Reads blocks and compares each with what was hashed.
     *
     * @param last block wanted; fewer are read when the buffer has no room for all
     */
    void readBlocks(long first, long last, ByteBuffer blocks) throws IOException {
        try {
            fill(first, last, blocks);
            for (int at = 0, block = (int) first; at < blocks.limit(); at += BLOCK_BYTES, block++) {
                if (sum(blocks.slice(at, Math.min(BLOCK_BYTES, blocks.limit() - at))) != sums[block])
                    throw new IOException("the archive's file was written into while it was served");
            }
        } catch (IOException e) {
            broken = true;
            throw e;
        }
    }

    private void fill(long first, long last, ByteBuffer blocks) throws IOException {
        long start = first * BLOCK_BYTES;
        long wanted = Math.min(bytes, (last + 1) * BLOCK_BYTES) - start;
        blocks.clear().limit((int) Math.min(blocks.capacity(), wanted));
        while (blocks.hasRemaining()) {
            if (channel.read(blocks, start + blocks.position()) < 0)
                throw new EOFException("the archive's file was cut while it was served");
        }
        blocks.flip();
    }

    private static int sum(ByteBuffer block) {
        CRC32C sum = new CRC32C();
        sum.update(block);
        return (int) sum.getValue();
    }

    private String hash() throws IOException {
        ByteBuffer block = BlockBuffers.take(BLOCK_BYTES);
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            for (int i = 0; i < sums.length; i++) {
                fill(i, i, block);
                sums[i] = sum(block.duplicate());
                digest.update(block);
            }
            return HexFormat.of().formatHex(digest.digest());
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        } finally {
            BlockBuffers.give(block);
        }
    }

    /** Whether a block could not be read or was another one: the file must be opened anew. */
    boolean isBroken() {
        return broken;
    }

    /** Whether nobody can begin to read any more. */
    synchronized boolean isClosed() {
        return closed;
    }

    /** Whether somebody is reading. */
    synchronized boolean isInUse() {
        return holders > (closed ? 0 : 1);
    }

    private synchronized boolean hold() {
        if (closed) return false;
        holders++;
        return true;
    }

    synchronized void release() {
        if (--holders > 0) return;
        try {
            channel.close();
        } catch (IOException e) {
            // It was open for reading only: nothing can be lost.
        }
    }

    /** Those who read go on to their end, nobody begins; then the file is closed. */
    @Override
    public synchronized void close() {
        if (closed) return;
        closed = true;
        release();
    }
}
