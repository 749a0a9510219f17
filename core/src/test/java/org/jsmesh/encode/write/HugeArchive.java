package org.jsmesh.encode.write;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.archive.Provenance;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.archive.coding.SplitPayload;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.MeshFormat;
import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.codec.exact.NumberForms;
import org.jsmesh.encode.CodedMeshes;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Sha256;
import org.jsmesh.mesh.UpAxis;

/** An archive of more than 2 GiB that takes little memory: images of zeros, then a poster, all of them one array. */
public final class HugeArchive {
    /** The bytes of the poster, at the end of the file. */
    public static final byte[] POSTER = {'p', 'o', 's', 't', 'e', 'r'};

    private static final int IMAGES = 18;
    private static final int IMAGE_BYTES = 2000 * 65532;
    private static final byte[] ZEROS = new byte[1 << 16];

    private final List<ByteBuffer> parts;

    private HugeArchive(List<ByteBuffer> parts) {
        this.parts = parts;
    }

    /** @param mesh of float32 without attributes, so small that all of it is base */
    public static HugeArchive of(Mesh mesh) throws MalformedStreamException {
        CodedMesh source = CodedMeshes.whole(mesh);
        MeshFormat format = MeshFormat.of(source);
        MeshCoder coder = MeshCoder.encoder(format, source);
        BatchList batches = new BatchList(coder, new PrecisionSchedule(format, mesh.bounds()));
        SplitPayload base = new SplitPayload(coder.hasAttributes());
        coder.codeBase(base.streams(), 0, 0);
        batches.add(BatchKind.BASE, base.finish(), 0);
        String zeros = Sha256.hex(new byte[IMAGE_BYTES]);
        List<ImageInfo> images = new ArrayList<>();
        for (int i = 0; i < IMAGES; i++) {
            images.add(new ImageInfo(List.of("zeros" + i), IMAGE_BYTES, zeros));
            for (int left = IMAGE_BYTES; left > 0; ) {
                int size = batches.addPortion(BatchKind.TEXTURE, ZEROS, ZEROS.length - Math.min(left, ZEROS.length));
                left -= size - (ZEROS.length - Math.min(left, ZEROS.length));
            }
        }
        batches.addWhole(BatchKind.POSTER, POSTER);
        ArchiveHeader header = new ArchiveHeader(
                mesh.faces(),
                mesh.vertices(),
                mesh.wedges(),
                List.of(),
                mesh.materials(),
                images,
                List.of(),
                mesh.origin(),
                mesh.bounds(),
                UpAxis.UNKNOWN,
                false,
                List.of(),
                MeshIdentity.sha256(mesh),
                Provenance.NONE,
                batches.rows.build());
        NumberForms forms = NumberForms.plain(mesh.channels());
        return new HugeArchive(ArchiveSerializer.of(header, format, forms, batches.payloads, ArchiveLayout.POSTER));
    }

    /** The bytes of the file in parts. */
    public List<ByteBuffer> parts() {
        return Collections.unmodifiableList(parts);
    }

    public long length() {
        return parts.stream().mapToLong(ByteBuffer::remaining).sum();
    }

    /** The bytes of the file from one of them on. */
    public InputStream from(long offset) {
        List<InputStream> streams = new ArrayList<>();
        long skip = offset;
        for (ByteBuffer part : parts) {
            int count = (int) Math.min(skip, part.remaining());
            skip -= count;
            int start = part.arrayOffset() + part.position() + count;
            if (count < part.remaining())
                streams.add(new ByteArrayInputStream(part.array(), start, part.remaining() - count));
        }
        return new SequenceInputStream(Collections.enumeration(streams));
    }
}
