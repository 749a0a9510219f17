package org.jsmesh.encode.write;

import java.io.ByteArrayOutputStream;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.TextureInfo;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.archive.coding.HeaderCoder;
import org.jsmesh.archive.coding.SplitPayload;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;

/** Assembles the bytes of an archive, see {@link ArchiveLayout}. */
final class ArchiveSerializer {
    /** Bytes of batches in front of the rest of the header. */
    private static final int BYTES_BEFORE_REST = 4096;

    private ArchiveSerializer() {}

    /** @param payloads of all batches without the one with the rest of the header; that one is put among them */
    static byte[] of(ArchiveHeader header, MeshFormat format, List<byte[]> payloads, boolean keepsOrder)
            throws MalformedStreamException {
        int early = 0; // batches, without the base, in front of the rest of the header
        long before = payloads.get(0).length;
        while (early < payloads.size() - 1 && before < BYTES_BEFORE_REST) before += payloads.get(++early).length;
        HeaderCoder coder = new HeaderCoder(header, format, format.hasComponents());
        RangeEncoder opening = new RangeEncoder();
        coder.codeOpening(opening, 0, early);
        RangeEncoder rest = new RangeEncoder();
        coder.codeRest(rest, payloads.size() - 1 - early);
        byte[] restPayload = SplitPayload.finish(rest);
        coder.codeRestBytes(restPayload.length);
        payloads.add(early + 1, restPayload);
        int features = (keepsOrder ? ArchiveLayout.ORDER : 0) | (format.hasComponents() ? ArchiveLayout.COMPONENTS : 0);
        return file(opening.finish(), payloads, features);
    }

    /** The header of an archive. Its channels are those of the format, which is written apart. */
    static ArchiveHeader header(Mesh mesh, List<ArchiveHeader.Level> levels, String meshSha256, BatchIndex index) {
        List<TextureInfo> textures = mesh.textures().stream()
                .map(t -> new TextureInfo(t.path(), t.bytes().length))
                .toList();
        return new ArchiveHeader(
                mesh.faces(),
                mesh.vertices(),
                mesh.wedges(),
                List.of(),
                mesh.materials(),
                textures,
                mesh.bounds(),
                levels,
                meshSha256,
                index);
    }

    private static byte[] file(byte[] opening, List<byte[]> payloads, int features) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        byte[] prefix = new byte[ArchiveLayout.OPENING_BYTES_AT + ArchiveLayout.varintBytes(opening.length)];
        System.arraycopy(ArchiveLayout.MAGIC, 0, prefix, 0, 3);
        prefix[3] = ArchiveLayout.VERSION;
        prefix[ArchiveLayout.FEATURES_AT] = (byte) features;
        ArchiveLayout.putVarint(prefix, ArchiveLayout.OPENING_BYTES_AT, opening.length);
        out.writeBytes(prefix);
        out.writeBytes(opening);
        byte[] head = out.toByteArray();
        byte[] crc = new byte[ArchiveLayout.CRC_BYTES];
        ArchiveLayout.putInt(crc, 0, ArchiveLayout.crc(head, 0, head.length));
        out.writeBytes(crc);
        for (byte[] payload : payloads) out.writeBytes(payload);
        return out.toByteArray();
    }
}
