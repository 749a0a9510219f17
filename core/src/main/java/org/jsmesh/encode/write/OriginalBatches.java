package org.jsmesh.encode.write;

import java.nio.ByteBuffer;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.Provenance;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.OrderCoder;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.codec.exact.NumberForms;
import org.jsmesh.codec.exact.RemainderCoder;
import org.jsmesh.mesh.ClosedSurface;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.UpAxis;

/**
 * The last batches of an archive: what makes the mesh of the codec the original, the original's order, and the poster.
 * They come when all else is coded.
 */
final class OriginalBatches {
    private final MeshCoder coder;
    private final BatchList batches;
    private final Mesh source;
    private Mesh exact; // what the source was before its numbers became what the codec knows
    private NumberForms forms;
    private boolean isClosed; // the exact mesh; found at the beginning, while there is room
    private byte[] poster = new byte[0];
    private Mesh inOrder; // whose order is kept, or null
    private Provenance provenance = Provenance.NONE;
    private UpAxis up = UpAxis.UNKNOWN;

    /** @param source the mesh that the codec knows */
    OriginalBatches(MeshCoder coder, BatchList batches, Mesh source) {
        this.coder = coder;
        this.batches = batches;
        this.source = source;
        exact = source;
        forms = NumberForms.plain(source.channels());
    }

    void keepExact(Mesh original, NumberForms numbers) {
        exact = original;
        forms = numbers;
    }

    void keepOrder(Mesh mesh) {
        inOrder = mesh;
    }

    /** @param jpeg the file; empty for none */
    void show(byte[] jpeg) {
        poster = jpeg;
    }

    void tell(Provenance from, UpAxis axis) {
        provenance = from;
        up = axis;
    }

    /** Begins to write. */
    void begin() {
        isClosed = ClosedSurface.is(exact);
    }

    /** The file in parts, when all batches are there. */
    List<ByteBuffer> archive(MeshFormat format, List<ArchiveHeader.Level> levels, String meshSha256)
            throws MalformedStreamException {
        ArchiveHeader header = ArchiveSerializer.header(
                exact, source.bounds(), levels, meshSha256, provenance, up, isClosed, batches.rows.build());
        int features = (inOrder == null ? 0 : ArchiveLayout.ORDER) | (poster.length == 0 ? 0 : ArchiveLayout.POSTER);
        return ArchiveSerializer.of(header, format, forms, batches.payloads, features);
    }

    void put() throws MalformedStreamException {
        putOriginal();
        if (poster.length > 0) batches.addWhole(BatchKind.POSTER, poster);
    }

    private void putOriginal() throws MalformedStreamException {
        boolean isWhole = !forms.hasRemainder() && exact.faceChannels().isEmpty();
        if (isWhole && inOrder == null) return;
        Mesh decoded = coder.snapshot(source.materials(), List.of(), List.of());
        byte[] bytes = new byte[0];
        if (!isWhole) {
            RangeEncoder stream = new RangeEncoder();
            RemainderCoder.write(stream, forms, decoded, exact, coder.ids());
            bytes = stream.finish();
            put(BatchKind.REMAINDER, bytes);
        }
        if (inOrder == null) return;
        List<FaceChannel> kinds =
                exact.faceChannels().stream().map(FaceChannel::kind).toList();
        Mesh whole = RemainderCoder.read(new RangeDecoder(bytes, 0, bytes.length), forms, decoded, kinds);
        RangeEncoder stream = new RangeEncoder();
        OrderCoder.write(stream, whole, inOrder);
        put(BatchKind.ORDER, stream.finish());
    }

    private void put(BatchKind kind, byte[] bytes) {
        for (int at = 0; at < bytes.length; ) at = batches.addPortion(kind, bytes, at);
    }
}
