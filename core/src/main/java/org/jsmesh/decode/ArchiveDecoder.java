package org.jsmesh.decode;

import java.util.Arrays;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.ArchiveOpening;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.archive.coding.ArchivePrefix;
import org.jsmesh.archive.coding.HeaderCoder;
import org.jsmesh.archive.coding.PreviewStages;
import org.jsmesh.archive.coding.SplitPayload;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.entropy.BatchStreams;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.mesh.GrowingMesh;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/**
 * Decodes an archive as its bytes arrive, in any portions. After every complete batch the mesh is valid and can be
 * shown. Not thread-safe.
 */
public final class ArchiveDecoder {
    private byte[] buffer = new byte[4096]; // bytes of the batch that is not complete
    private int buffered;
    private long received;
    private MalformedStreamException failure;
    private ArchiveOpening opening; // null until it has come
    private ArchiveHeader header; // null until it has come whole
    private MeshCoder coder;
    private int batches;
    private int headBytes; // up to the base payload, or 0
    private HeaderCoder headerCoder;
    private final OriginalParts parts = new OriginalParts();
    private final PreviewStages previews = new PreviewStages();
    private GrowingMesh growing; // once the opening is there

    /**
     * Takes the next bytes of the file and applies every batch that they complete.
     *
     * @param bytes an array that holds them; it is read before the call ends, not kept
     * @param offset of the first of them in the array
     * @param length number of bytes, 0 or more
     * @throws MalformedStreamException when the bytes are not an archive; the decoder takes no more. After a wrong
     *     checksum it stays at the last good batch. A batch with a right checksum that cannot be decoded was made to
     *     deceive. The decoder then forgets all batches
     */
    public void feed(byte[] bytes, int offset, int length) throws MalformedStreamException {
        if (failure != null) throw failure;
        if (offset < 0 || length < 0 || length > bytes.length - offset)
            throw new IllegalArgumentException("bytes " + offset + " + " + length + " of " + bytes.length);
        try {
            take(bytes, offset, length);
        } catch (MalformedStreamException e) {
            failure = e.offset() >= 0 ? e : new MalformedStreamException(start(), e.getMessage());
            throw failure;
        }
    }

    private long start() {
        return received - buffered;
    }

    private void take(byte[] bytes, int offset, int length) throws MalformedStreamException {
        int at = offset;
        int end = offset + length;
        while (at < end) {
            int wanted = wanted();
            if (wanted < 0) throw new MalformedStreamException(received, "there are bytes after the last batch");
            int n = Math.min(end - at, wanted - buffered);
            if (buffered + n > buffer.length)
                buffer = Arrays.copyOf(buffer, (int) Math.min(wanted, Math.max(buffered + n, 2L * buffer.length)));
            System.arraycopy(bytes, at, buffer, buffered, n);
            at += n;
            buffered += n;
            received += n;
            if (buffered == wanted) advance();
        }
    }

    /**
     * Bytes that the buffer must hold for the next step: the prefix, then the header, then whole batches; −1 at the
     * end.
     */
    private int wanted() throws MalformedStreamException {
        if (opening == null) {
            if (headBytes > 0) return headBytes;
            return Math.max(ArchiveLayout.OPENING_BYTES_AT, buffered) + 1;
        }
        if (batches == 0) return index().bytes(0);
        return isComplete() ? -1 : index().bytes(batches);
    }

    private void advance() throws MalformedStreamException {
        if (opening == null) {
            if (headBytes == 0) headBytes = ArchivePrefix.headBytes(buffer, buffered);
            else readOpening();
            return;
        }
        int begin = batches == 0 ? headBytes : 0;
        int length = buffered - begin - ArchiveLayout.CRC_BYTES;
        ArchiveLayout.checkCrc(buffer, begin, length, start());
        BatchKind kind = index().kind(batches);
        if (OriginalParts.hold(kind)) parts.take(kind, opening.images(), buffer, begin, length);
        else if (kind == BatchKind.PREVIEW)
            previews.decode(buffer, begin, length, opening.images().size());
        else if (kind != BatchKind.POSTER) decodeOrForget(begin, length);
        batches++;
        buffered = 0;
        if (isComplete()) finish();
    }

    private void finish() throws MalformedStreamException {
        if (coder.sweeps().coarseWedges() > 0)
            throw new MalformedStreamException(-1, "the file ends before the attributes are exact");
        int good = batches;
        batches = 0;
        parts.finish(coder, headerCoder.forms(), header);
        batches = good;
    }

    private void readOpening() throws MalformedStreamException {
        int end = headBytes - ArchiveLayout.CRC_BYTES;
        ArchiveLayout.checkCrc(buffer, 0, end, 0);
        int start = ArchiveLayout.OPENING_BYTES_AT;
        while (buffer[start++] < 0) {}
        RangeDecoder stream = new RangeDecoder(buffer, start, end - start);
        headerCoder = new HeaderCoder(null, null, null, buffer[ArchiveLayout.FEATURES_AT] & 0xff);
        headerCoder.codeOpening(stream, headBytes, 0);
        ArchiveOpening read = headerCoder.codeRestBytes(0);
        if (stream.isExhausted()) throw new MalformedStreamException(-1, "the header ends early");
        BatchIndex known = read.batches();
        int last = known.size() - 1;
        coder = MeshCoder.decoder(headerCoder.format(), known.vertices(last), known.faces(last));
        growing = coder.growing(headerCoder.forms());
        opening = read;
    }

    private void readRest(int offset, int length) throws MalformedStreamException {
        ArchiveHeader read = headerCoder.codeRest(new RangeDecoder(buffer, offset, length), 0);
        checkTextures(read);
        header = read;
    }

    private static void checkTextures(ArchiveHeader h) throws MalformedStreamException {
        long sent = 0;
        for (int b = 0; b < h.batches().size(); b++) {
            if (h.batches().kind(b) == BatchKind.TEXTURE) sent += h.batches().bytes(b) - ArchiveLayout.CRC_BYTES;
        }
        long claimed = 0;
        for (ImageInfo image : h.images()) claimed += image.bytes();
        if (sent != claimed)
            throw new MalformedStreamException(-1, "textures of " + claimed + " bytes in batches of " + sent);
    }

    private void decodeOrForget(int offset, int length) throws MalformedStreamException {
        int good = batches;
        batches = 0;
        decode(good, offset, length);
        batches = good;
    }

    private void decode(int batch, int offset, int length) throws MalformedStreamException {
        BatchIndex index = index();
        BatchKind kind = index.kind(batch);
        if (kind == BatchKind.HEADER) {
            readRest(offset, length);
            return;
        }
        if (kind == BatchKind.PRECISION || kind == BatchKind.ATTRIBUTES) {
            RangeDecoder stream = new RangeDecoder(buffer, offset, length);
            if (kind == BatchKind.PRECISION && coder.sweeps().isAmidAttributes())
                throw new MalformedStreamException(-1, "batch " + batch + " comes amid attributes");
            boolean begins = kind == BatchKind.PRECISION && !coder.sweeps().isSweeping();
            if (begins) coder.sweeps().begin(index.shift(batch));
            if (kind == BatchKind.PRECISION) coder.sweeps().code(stream, index.patches(batch));
            else coder.sweeps().codeAttributes(stream, index.patches(batch));
            if (stream.isExhausted()) throw new MalformedStreamException(-1, "batch " + batch + " ends early");
            return;
        }
        int passes = batch == 0 ? 0 : index.pass(batch) - index.pass(batch - 1);
        int drops = passes == 0 ? 0 : index.shift(batch - 1) - index.shift(batch);
        SplitPayload.Opened payload = SplitPayload.open(buffer, offset, length, coder.hasAttributes(), passes, drops);
        BatchStreams streams = payload.streams();
        if (batch == 0) {
            coder.sweeps().setPrecision(index.shift(0));
            coder.codeBase(streams, index.faces(0), index.vertices(0));
        } else {
            coder.expectFaces(index.faces(batch));
            decodeSplits(payload, index.patches(batch));
        }
        if (streams.isExhausted()) throw new MalformedStreamException(-1, "batch " + batch + " ends early");
        if (coder.faces() != index.faces(batch) || coder.vertices() != index.vertices(batch)) {
            throw new MalformedStreamException(
                    -1, "batch " + batch + " gives " + coder.faces() + " faces, the index says " + index.faces(batch));
        }
    }

    private void decodeSplits(SplitPayload.Opened payload, int splits) throws MalformedStreamException {
        BatchStreams streams = payload.streams();
        int left = splits;
        for (SplitPayload.Start start : payload.starts()) {
            if (start.splitsBefore() > left)
                throw new MalformedStreamException(-1, "a pass begins after the end of its batch");
            coder.codeSplits(streams, start.splitsBefore());
            left -= start.splitsBefore();
            coder.sweeps().codeBeforePass(streams.geometry(), start.drop(), false);
            coder.beginPass(-1);
        }
        coder.codeSplits(streams, left);
    }

    /** {@return the number of bytes fed so far} */
    public long received() {
        return received;
    }

    /** {@return what the first bytes say; null until they have arrived} */
    public ArchiveOpening opening() {
        return opening;
    }

    /** {@return the header; null until all of it has arrived, some batches after the {@link #opening}} */
    public ArchiveHeader header() {
        return header;
    }

    /**
     * {@return the index as far as it is known: null at first, the rows of the {@link #opening}, then those of the
     * {@link #header}, which are all}
     */
    public BatchIndex index() {
        if (header != null) return header.batches();
        return opening == null ? null : opening.batches();
    }

    /** {@return the number of batches applied: 0 until the base has arrived} */
    public int batches() {
        return batches;
    }

    /** {@return true when every batch is applied} */
    public boolean isComplete() {
        return header != null && batches == header.batches().size();
    }

    /** {@return the number of faces of the mesh shown now; 0 before the base} */
    public int faces() {
        return batches == 0 ? 0 : coder.faces();
    }

    /**
     * Follows the mesh while batches are applied.
     *
     * @return what is shown now, which every batch changes; null until the {@link #opening} has arrived. It lacks the
     *     attributes of faces, which the {@link #mesh} has once the last batch is applied
     */
    public GrowingMesh growing() {
        return growing;
    }

    /**
     * Copies the mesh as it is after the batches applied so far, with the textures that have arrived whole, and
     * previews of others. An image with several paths is there under each of them; these share its bytes.
     *
     * @return a mesh that later batches leave as it is
     * @throws IllegalStateException before the base has arrived
     */
    public Mesh mesh() {
        if (batches == 0) throw new IllegalStateException("the base has not arrived");
        List<Texture> textures = parts.textures(opening.images());
        List<Picture> stillSmall = previews.pictures(opening.images(), parts.wholeImages());
        if (parts.original() != null)
            return MeshBuilder.from(parts.original()).textures(textures).build();
        return headerCoder.forms().shown(coder.snapshot(opening.materials(), textures, stillSmall));
    }

    /**
     * Gives the original with its vertices, faces and corners in their order, where the archive holds that.
     *
     * @return the original in its order, else the {@link #mesh}
     * @throws IllegalStateException before the last batch has arrived
     * @throws MalformedStreamException when the order in the archive is none
     */
    public Mesh meshInOrder() throws MalformedStreamException {
        if (!isComplete()) throw new IllegalStateException("the last batch has not arrived");
        return parts.inOrder(mesh());
    }
}
