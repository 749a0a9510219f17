package org.jsmesh.encode.write;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.FaceChannelInfo;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.archive.Provenance;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.archive.coding.HeaderCoder;
import org.jsmesh.archive.coding.SplitPayload;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.codec.exact.NumberForms;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.UpAxis;

/** Assembles an archive of its parts, see {@link ArchiveLayout}. */
final class ArchiveSerializer {
    /** Bytes of batches in front of the rest of the header. */
    private static final int BYTES_BEFORE_REST = 4096;

    private ArchiveSerializer() {}

    /**
     * @param payloads of all batches without the one with the rest of the header; that one is put among them
     * @param given features that the other arguments do not tell
     */
    static List<ByteBuffer> of(
            ArchiveHeader header, MeshFormat format, NumberForms forms, List<Payload> payloads, int given)
            throws MalformedStreamException {
        int early = 0; // batches, without the base, in front of the rest of the header
        long before = payloads.get(0).length();
        while (early < payloads.size() - 1 && before < BYTES_BEFORE_REST)
            before += payloads.get(++early).length();
        boolean isPlain = forms.isPlain() && header.faceChannels().isEmpty();
        int features = given
                | (format.hasComponents() ? ArchiveLayout.COMPONENTS : 0)
                | (isPlain ? 0 : ArchiveLayout.REMAINDER)
                | (header.isClosed() ? ArchiveLayout.CLOSED : 0)
                | (header.batches().errorMean(0) > 0 ? ArchiveLayout.FURTHER | ArchiveLayout.QUANTILES : 0)
                | ArchiveLayout.feature(header.up());
        HeaderCoder coder = new HeaderCoder(header, format, forms, features);
        RangeEncoder opening = new RangeEncoder();
        coder.codeOpening(opening, 0, early);
        RangeEncoder rest = new RangeEncoder();
        coder.codeRest(rest, payloads.size() - 1 - early);
        byte[] restPayload = SplitPayload.finish(rest);
        coder.codeRestBytes(restPayload.length);
        payloads.add(early + 1, Payload.of(restPayload));
        return file(opening.finish(), payloads, features);
    }

    /** The header of an archive. Its channels are those of the format, which is written apart. */
    static ArchiveHeader header(
            Mesh mesh,
            float[] bounds,
            List<ArchiveHeader.Level> levels,
            String meshSha256,
            Provenance provenance,
            UpAxis up,
            boolean isClosed,
            BatchIndex index) {
        List<ImageInfo> images =
                SharedImage.of(mesh.textures()).stream().map(SharedImage::info).toList();
        return new ArchiveHeader(
                mesh.faces(),
                mesh.vertices(),
                mesh.wedges(),
                List.of(),
                mesh.materials(),
                images,
                mesh.faceChannels().stream()
                        .map(c -> new FaceChannelInfo(c.name(), c.components(), c.type()))
                        .toList(),
                mesh.origin(),
                bounds,
                up,
                isClosed,
                levels,
                meshSha256,
                provenance.bounded(),
                index);
    }

    private static List<ByteBuffer> file(byte[] opening, List<Payload> payloads, int features) {
        int start = ArchiveLayout.OPENING_BYTES_AT + ArchiveLayout.varintBytes(opening.length);
        int end = start + opening.length;
        byte[] head = new byte[end + ArchiveLayout.CRC_BYTES];
        System.arraycopy(ArchiveLayout.MAGIC, 0, head, 0, 3);
        head[3] = ArchiveLayout.VERSION;
        head[ArchiveLayout.FEATURES_AT] = (byte) features;
        ArchiveLayout.putVarint(head, ArchiveLayout.OPENING_BYTES_AT, opening.length);
        System.arraycopy(opening, 0, head, start, opening.length);
        ArchiveLayout.putInt(head, end, ArchiveLayout.crc(head, 0, end));
        List<ByteBuffer> parts = new ArrayList<>();
        parts.add(ByteBuffer.wrap(head));
        for (Payload payload : payloads) payload.addTo(parts);
        return parts;
    }
}
