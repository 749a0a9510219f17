package org.jsmesh.archive;

import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.archive.coding.SplitPayload;
import org.jsmesh.codec.CoderStages;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.entropy.BatchStreams;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;

/**
 * The batches of splits that lie wholly within an archive's last pass, opened but not decoded, with a coder that has
 * decoded all before them. To be used once.
 */
final class FinestPass {
    private final MeshCoder coder;
    private final CoderStages stages;
    private final List<BatchStreams> streams = new ArrayList<>();
    private final List<Integer> counts = new ArrayList<>();
    private int faces;
    private int end;

    FinestPass(byte[] archive) throws MalformedStreamException {
        BatchIndex index = index(archive);
        int last = index.pass(index.size() - 1);
        int first = 0;
        while (index.pass(first) < last) first++;
        do first++;
        while (index.kind(first) != BatchKind.SPLITS);
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, (int) index.offset(first));
        coder = coder(decoder);
        int splits = 0;
        for (int b = first; b < index.size() && index.kind(b) == BatchKind.SPLITS; b++) {
            int length = index.bytes(b) - ArchiveLayout.CRC_BYTES;
            streams.add(SplitPayload.open(archive, (int) index.offset(b), length, false, 0, 0)
                    .streams());
            counts.add(index.patches(b));
            splits += index.patches(b);
            end = (int) index.end(b);
            faces = index.faces(b) - index.faces(first - 1);
        }
        stages = new CoderStages(coder, splits);
    }

    private static BatchIndex index(byte[] archive) throws MalformedStreamException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        for (int at = 0; decoder.header() == null; at++) decoder.feed(archive, at, 1);
        return decoder.header().batches();
    }

    private static MeshCoder coder(ArchiveDecoder decoder) {
        try {
            Field field = ArchiveDecoder.class.getDeclaredField("coder");
            field.setAccessible(true);
            return (MeshCoder) field.get(decoder);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Faces that the pass adds. */
    int faces() {
        return faces;
    }

    int applySplits() throws MalformedStreamException {
        for (int b = 0; b < streams.size(); b++)
            stages.applySplits(streams.get(b).connectivity(), counts.get(b));
        return stages.vertices();
    }

    int placeVertices() throws MalformedStreamException {
        for (int b = 0; b < streams.size(); b++)
            stages.placeVertices(streams.get(b).geometry(), counts.get(b));
        return stages.vertices();
    }

    /**
     * Decodes the pass and compares with what the decoder makes of the same bytes: figures about anything else would be
     * worthless.
     */
    static void check(byte[] archive) throws MalformedStreamException {
        FinestPass pass = new FinestPass(archive);
        pass.applySplits();
        pass.placeVertices();
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, pass.end);
        Mesh mesh = pass.coder.snapshot(List.of(), List.of(), List.of());
        if (!MeshIdentity.sha256(mesh).equals(MeshIdentity.sha256(decoder.mesh())))
            throw new IllegalStateException("the stages together do not what the decoder does");
    }
}
