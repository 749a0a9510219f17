package org.jsmesh.store;

import java.io.IOException;
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
 * The bytes of an archive file, mapped into memory, and its header. Immutable as long as nobody writes into the file in
 * place; thread-safe.
 */
public final class Archive {
    /** One buffer spans less than 2 GiB. */
    private static final int SEGMENT_BITS = 30;

    private final ByteBuffer[] segments;
    private final int segmentBits;
    private final long bytes;
    private final String sha256;
    private final ArchiveHeader header;

    private Archive(ByteBuffer[] segments, int segmentBits, long bytes, HeaderReader reader)
            throws MalformedStreamException {
        this.segments = segments;
        this.segmentBits = segmentBits;
        this.bytes = bytes;
        header = reader.read(this);
        long claimed = header.batches().archiveBytes();
        if (claimed != bytes)
            throw new MalformedStreamException(
                    bytes, "the index speaks of " + claimed + " bytes, the file has " + bytes);
        sha256 = hash();
    }

    /**
     * Maps the file, reads its header and hashes it.
     *
     * @param file a whole archive, of any size; it must not be written into afterwards, but may be replaced or removed
     * @return the archive; its memory is released when nobody refers to it
     * @throws MalformedStreamException when it is no archive, or its length does not agree with its index
     * @throws IOException when it cannot be read
     */
    public static Archive open(Path file) throws IOException {
        return open(file, HeaderReader.DECODER);
    }

    static Archive open(Path file, HeaderReader reader) throws IOException {
        return open(file, reader, SEGMENT_BITS);
    }

    static Archive open(Path file, HeaderReader reader, int segmentBits) throws IOException {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
            long size = channel.size();
            long segment = 1L << segmentBits;
            ByteBuffer[] segments = new ByteBuffer[(int) ((size + segment - 1) >>> segmentBits)];
            for (int i = 0; i < segments.length; i++) {
                long start = i * segment;
                segments[i] = channel.map(FileChannel.MapMode.READ_ONLY, start, Math.min(segment, size - start));
            }
            return new Archive(segments, segmentBits, size, reader);
        }
    }

    /** {@return the size of the file} */
    public long bytes() {
        return bytes;
    }

    /** {@return the SHA-256 of the file's bytes, in lower-case hexadecimal} */
    public String sha256() {
        return sha256;
    }

    /** {@return what the archive says of itself} */
    public ArchiveHeader header() {
        return header;
    }

    /** {@return the index, with the place of every batch in the file} */
    public BatchIndex batches() {
        return header.batches();
    }

    /**
     * A read-only view of at most {@code length} bytes from {@code offset} on, without a copy. It is shorter at the
     * borders of the mapped segments; ask again for the bytes behind it.
     *
     * @param offset of the first byte from the start of the file
     * @param length most bytes wanted; 0 gives an empty view
     * @return the view, from position 0 on; at least one byte when {@code length} is not 0
     * @throws IllegalArgumentException when the range is not within the file
     */
    public ByteBuffer slice(long offset, long length) {
        if (offset < 0 || length < 0 || offset + length > bytes) {
            throw new IllegalArgumentException("bytes " + offset + " to " + (offset + length) + " of " + bytes);
        }
        if (length == 0) return ByteBuffer.allocate(0);
        ByteBuffer segment = segments[(int) (offset >>> segmentBits)];
        int start = (int) (offset & ((1L << segmentBits) - 1));
        return segment.slice(start, (int) Math.min(length, segment.limit() - start));
    }

    /**
     * A copy of some bytes.
     *
     * @param offset of the first byte from the start of the file
     * @param length number of bytes
     * @return the bytes
     * @throws IllegalArgumentException when the range is not within the file
     */
    public byte[] copy(long offset, int length) {
        byte[] copy = new byte[length];
        for (int at = 0; at < length; ) {
            ByteBuffer slice = slice(offset + at, length - at);
            int count = slice.remaining();
            slice.get(copy, at, count);
            at += count;
        }
        return copy;
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
