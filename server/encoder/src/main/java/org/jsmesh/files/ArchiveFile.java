package org.jsmesh.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.zip.CRC32;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.ArchiveOpening;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.Proof;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;

/**
 * The bytes of an archive, or of the first part of one, and the meshes in them. It needs only the file: no sidecar, no
 * name. Immutable and thread-safe.
 */
public final class ArchiveFile {
    private static final int PORTION = 1 << 16;

    private final byte[] bytes;
    private final ArchiveOpening opening;
    private final ArchiveHeader header; // null when the file is cut before its end

    private ArchiveFile(byte[] bytes, ArchiveOpening opening, ArchiveHeader header) {
        this.bytes = bytes;
        this.opening = opening;
        this.header = header;
    }

    /**
     * Reads the file into memory.
     *
     * @param file an archive, or the first part of one, of less than 2 GiB
     * @return the archive; no mesh is decoded yet
     * @throws MalformedStreamException when the file does not begin like an archive, ends within its opening, or goes
     *     on after its end
     * @throws IOException when it cannot be read
     */
    public static ArchiveFile read(Path file) throws IOException {
        return of(ModelFiles.bytes(file));
    }

    /**
     * Takes the bytes of an archive, or of the first part of one.
     *
     * @param bytes shared, not copied
     * @return the archive
     * @throws MalformedStreamException when they do not begin as an archive does, or go on after its end
     */
    public static ArchiveFile of(byte[] bytes) throws MalformedStreamException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        for (int at = 0; at < bytes.length && decoder.header() == null; ) {
            int count = Math.min(1024, bytes.length - at);
            decoder.feed(bytes, at, count);
            at += count;
        }
        BatchIndex index = decoder.index();
        if (index == null) throw new MalformedStreamException(bytes.length, "the file ends before its header does");
        long excess = bytes.length - index.archiveBytes();
        if (excess > 0)
            throw new MalformedStreamException(index.archiveBytes(), excess + " bytes follow the end of the archive");
        return new ArchiveFile(bytes, decoder.opening(), decoder.header());
    }

    /** {@return what the first bytes say; never null} */
    public ArchiveOpening opening() {
        return opening;
    }

    /** {@return the header; null when the file is cut before the header's end} */
    public ArchiveHeader header() {
        return header;
    }

    /** {@return the index: all of it, or the first rows where {@link #header} is null} */
    public BatchIndex index() {
        return header == null ? opening.batches() : header.batches();
    }

    /** {@return the number of bytes there are, fewer than the index says when the file is cut} */
    public int length() {
        return bytes.length;
    }

    /** {@return the number of whole batches there are} */
    public int batches() {
        return index().batchesWithin(bytes.length);
    }

    /** {@return false when the file is cut} */
    public boolean isWhole() {
        return header != null && bytes.length == header.batches().archiveBytes();
    }

    /** {@return what the archive holds; without the hash of the file when the file is cut} */
    public ArchiveReport report() {
        return header == null ? ArchiveReport.of(opening) : ArchiveReport.of(header, isWhole() ? sha256() : null);
    }

    /**
     * Decodes the mesh that is shown once a batch has arrived.
     *
     * @param batch 0 to {@code batches() - 1}
     * @param progress hears how far the work is and may stop it
     * @return the mesh
     * @throws MalformedStreamException when a batch up to that one is damaged
     */
    public Mesh meshAfter(int batch, ProgressListener progress) throws MalformedStreamException {
        return decodedTo(batch, progress).mesh();
    }

    private ArchiveDecoder decodedTo(int batch, ProgressListener progress) throws MalformedStreamException {
        if (batch < 0 || batch >= batches()) throw new IllegalArgumentException("batch " + batch + " of " + batches());
        ArchiveDecoder decoder = new ArchiveDecoder();
        int end = (int) index().end(batch);
        for (int at = 0; at < end; ) {
            progress.step("decode", (double) at / end);
            int count = Math.min(PORTION, end - at);
            decoder.feed(bytes, at, count);
            at += count;
        }
        if (decoder.batches() != batch + 1)
            throw new MalformedStreamException(end, "batch " + batch + " does not end where the index says");
        return decoder;
    }

    /**
     * The original, in its order if the archive holds the order. Mesh and images are checked against their hashes in
     * the header.
     *
     * @param progress hears how far the work is and may stop it
     * @return the mesh
     * @throws MalformedStreamException also when the file is cut, or the decoded mesh or an image is not the one that
     *     the header names
     */
    public Mesh original(ProgressListener progress) throws MalformedStreamException {
        if (!isWhole())
            throw new MalformedStreamException(
                    bytes.length, "the file ends after " + batches() + " of " + index().size() + " batches");
        Mesh mesh = decodedTo(batches() - 1, progress).meshInOrder();
        progress.step("check", 0);
        String difference = Proof.of(header, mesh).difference();
        if (!difference.isEmpty()) throw new MalformedStreamException(-1, difference);
        return mesh;
    }

    /**
     * Cuts out the poster. Nothing is decoded.
     *
     * @return a JPEG file, or null when the archive has none, or is cut before its end
     * @throws MalformedStreamException when the poster is damaged
     */
    public byte[] poster() throws MalformedStreamException {
        int batch = index().poster();
        if (batch < 0 || index().end(batch) > bytes.length) return null;
        int begin = (int) index().offset(batch);
        int end = begin + BatchIndex.payloadBytes(index().bytes(batch));
        CRC32 sum = new CRC32();
        sum.update(bytes, begin, end - begin);
        ByteBuffer kept = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        if (kept.getInt(end) != (int) sum.getValue())
            throw new MalformedStreamException(
                    begin, "the poster's checksum does not match: the file is damaged; fetch it again");
        return Arrays.copyOfRange(bytes, begin, end);
    }

    /** {@return the SHA-256 of the bytes that are there, in lower-case hexadecimal; computed by each call} */
    public String sha256() {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
