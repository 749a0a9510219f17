package org.jsmesh.files;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.zip.CRC32;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.ArchiveOpening;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.Proof;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ByteSource;

/**
 * The bytes of an archive, or of the first part of one, and the meshes in them. It needs only the file: no sidecar, no
 * name. Small archives are in memory; of a large one the bytes stay in the file, which is read again when they are
 * needed and must not change meanwhile. Immutable and thread-safe.
 */
public final class ArchiveFile {
    private static final int PORTION = 1 << 16;

    private final ByteSource bytes;
    private final ArchiveOpening opening;
    private final ArchiveHeader header; // null when the file is cut before its end

    private ArchiveFile(ByteSource bytes, ArchiveOpening opening, ArchiveHeader header) {
        this.bytes = bytes;
        this.opening = opening;
        this.header = header;
    }

    /**
     * Reads what the file says of itself, and all of a small file.
     *
     * @param file an archive, or the first part of one, of any size
     * @return the archive; no mesh is decoded yet
     * @throws MalformedStreamException when the file does not begin like an archive, ends within its opening, or goes
     *     on after its end
     * @throws IOException when it cannot be read
     */
    public static ArchiveFile read(Path file) throws IOException {
        return of(FileSource.isFor(file) ? FileSource.of(file) : ByteSource.of(ModelFiles.bytes(file)));
    }

    /**
     * Takes the bytes of an archive, or of the first part of one.
     *
     * @param bytes shared, not copied
     * @return the archive
     * @throws MalformedStreamException when they do not begin as an archive does, or go on after its end
     */
    public static ArchiveFile of(byte[] bytes) throws MalformedStreamException {
        try {
            return of(ByteSource.of(bytes));
        } catch (MalformedStreamException e) {
            throw e;
        } catch (IOException e) {
            throw new IllegalStateException(e); // nothing else can be wrong with an array
        }
    }

    static ArchiveFile of(ByteSource bytes) throws IOException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        byte[] portion = new byte[1024];
        try (InputStream in = bytes.from(0)) {
            while (decoder.header() == null) {
                int count = in.read(portion);
                if (count < 0) break;
                decoder.feed(portion, 0, count);
            }
        }
        BatchIndex index = decoder.index();
        if (index == null) throw new MalformedStreamException(bytes.length(), "the file ends before its header does");
        long excess = bytes.length() - index.archiveBytes();
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
    public long length() {
        return bytes.length();
    }

    /** {@return the number of whole batches there are} */
    public int batches() {
        return index().batchesWithin(bytes.length());
    }

    /** {@return false when the file is cut} */
    public boolean isWhole() {
        return header != null && bytes.length() == header.batches().archiveBytes();
    }

    /**
     * Tells what the archive holds.
     *
     * @return a report without the hash of the file when the file is cut
     * @throws IOException when the file cannot be read any more
     */
    public ArchiveReport report() throws IOException {
        return header == null ? ArchiveReport.of(opening) : ArchiveReport.of(header, isWhole() ? sha256() : null);
    }

    /**
     * Decodes the mesh that is shown once a batch has arrived.
     *
     * @param batch 0 to {@code batches() - 1}
     * @param progress hears how far the work is and may stop it
     * @return the mesh
     * @throws MalformedStreamException when a batch up to that one is damaged
     * @throws IOException when the file cannot be read any more
     */
    public Mesh meshAfter(int batch, ProgressListener progress) throws IOException {
        return decodedTo(batch, progress).mesh();
    }

    private ArchiveDecoder decodedTo(int batch, ProgressListener progress) throws IOException {
        if (batch < 0 || batch >= batches()) throw new IllegalArgumentException("batch " + batch + " of " + batches());
        ArchiveDecoder decoder = new ArchiveDecoder();
        long end = index().end(batch);
        byte[] portion = new byte[(int) Math.min(PORTION, end)];
        try (InputStream in = bytes.from(0)) {
            while (decoder.received() < end) {
                progress.step("decode", (double) decoder.received() / end);
                int count = in.read(portion, 0, (int) Math.min(portion.length, end - decoder.received()));
                if (count < 0) throw cut();
                decoder.feed(portion, 0, count);
            }
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
     * @throws IOException when the file cannot be read any more
     */
    public Mesh original(ProgressListener progress) throws IOException {
        if (!isWhole())
            throw new MalformedStreamException(
                    bytes.length(), "the file ends after " + batches() + " of " + index().size() + " batches");
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
     * @throws IOException when the file cannot be read any more
     */
    public byte[] poster() throws IOException {
        int batch = index().poster();
        if (batch < 0 || index().end(batch) > bytes.length()) return null;
        long begin = index().offset(batch);
        byte[] kept;
        try (InputStream in = bytes.from(begin)) {
            kept = in.readNBytes(index().bytes(batch));
        }
        if (kept.length < index().bytes(batch)) throw cut();
        int size = BatchIndex.payloadBytes(kept.length);
        CRC32 sum = new CRC32();
        sum.update(kept, 0, size);
        if (ByteBuffer.wrap(kept).order(ByteOrder.LITTLE_ENDIAN).getInt(size) != (int) sum.getValue())
            throw new MalformedStreamException(
                    begin, "the poster's checksum does not match: the file is damaged; fetch it again");
        return Arrays.copyOf(kept, size);
    }

    /**
     * Hashes the file; each call does so anew.
     *
     * @return the SHA-256 of the bytes that are there, in lower-case hexadecimal
     * @throws IOException when the file cannot be read any more
     */
    public String sha256() throws IOException {
        try (InputStream in = bytes.from(0)) {
            return Hashes.sha256(in);
        }
    }

    private static EOFException cut() {
        return new EOFException("the file was cut while it was read");
    }
}
