package org.jsmesh.store;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * The bytes of an archive file, mapped into memory, and what it says of itself. Immutable as long as nobody writes into the file in place;
 * thread-safe.
 */
public final class Archive {
    private static final int SEGMENT_BITS = 30;
    private static final int SEGMENT = 1 << SEGMENT_BITS;

    private final ByteBuffer[] segments;
    private final long bytes;
    private final String sha256;
    private final ArchiveHeader header;

    private Archive(ByteBuffer[] segments, long bytes, HeaderReader reader) throws MalformedStreamException {
        this.segments = segments;
        this.bytes = bytes;
        header = reader.read(this);
        long claimed = header.batches().archiveBytes();
        if (claimed != bytes)
            throw new MalformedStreamException(
                    bytes, "the index speaks of " + claimed + " bytes, the file has " + bytes);
        sha256 = hash();
    }

    /** Maps the file, reads its header and hashes it. */
    static Archive open(Path file, HeaderReader reader) throws IOException {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
            long size = channel.size();
            ByteBuffer[] segments = new ByteBuffer[(int) ((size + SEGMENT - 1) >>> SEGMENT_BITS)];
            for (int i = 0; i < segments.length; i++) {
                long start = (long) i << SEGMENT_BITS;
                segments[i] = channel.map(FileChannel.MapMode.READ_ONLY, start, Math.min(SEGMENT, size - start));
            }
            return new Archive(segments, size, reader);
        }
    }

    /** Size of the file. */
    public long bytes() {
        return bytes;
    }

    /** SHA-256 of the file's bytes in lower-case hexadecimal. */
    public String sha256() {
        return sha256;
    }

    public ArchiveHeader header() {
        return header;
    }

    public BatchIndex batches() {
        return header.batches();
    }

    /**
     * A read-only view of at most {@code length} bytes from {@code offset} on, without a copy. Shorter at the borders of the mapped segments:
     * go on behind what it holds.
     */
    public ByteBuffer slice(long offset, long length) {
        if (offset < 0 || length < 0 || offset + length > bytes) {
            throw new IllegalArgumentException("bytes " + offset + " to " + (offset + length) + " of " + bytes);
        }
        if (length == 0) return ByteBuffer.allocate(0);
        int start = (int) (offset & (SEGMENT - 1));
        int count = (int) Math.min(length, SEGMENT - start);
        return segments[(int) (offset >>> SEGMENT_BITS)].slice(start, count);
    }

    /** Copies bytes into {@code out}; for small ranges and tests. */
    public void copy(long offset, long length, OutputStream out) throws IOException {
        byte[] block = new byte[(int) Math.min(length, 1 << 16)];
        for (long at = offset; at < offset + length; ) {
            ByteBuffer slice = slice(at, Math.min(block.length, offset + length - at));
            int count = slice.remaining();
            slice.get(block, 0, count);
            out.write(block, 0, count);
            at += count;
        }
    }

    private String hash() {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            for (ByteBuffer segment : segments) digest.update(segment.duplicate());
            return HexFormat.of().formatHex(digest.digest());
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
