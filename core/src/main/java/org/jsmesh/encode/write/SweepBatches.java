package org.jsmesh.encode.write;

import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.archive.coding.SplitPayload;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes sweeps over all vertices, which make positions more precise, and over all wedges, which make attributes exact,
 * in batches of their own.
 */
final class SweepBatches {
    private static final int BITS_AT_ONCE = 64;
    private static final int CODER_BYTES = 8; // that a range coder still holds

    private final MeshCoder coder;
    private final BatchList batches;

    SweepBatches(MeshCoder coder, BatchList batches) {
        this.coder = coder;
        this.batches = batches;
    }

    private int room() {
        return batches.cap() - ArchiveLayout.CRC_BYTES - CODER_BYTES;
    }

    /**
     * Brings all vertices to a precision.
     *
     * @param afterBatch is run after every batch but the last
     */
    void codePositions(int shift, Runnable afterBatch) throws MalformedStreamException {
        int from = coder.sweeps().precision();
        int bitsPerVertex = Math.max(1, 3 * (from - shift));
        coder.sweeps().begin(shift);
        while (coder.sweeps().unrefined() > 0) {
            int room = room();
            RangeEncoder stream = new RangeEncoder();
            int count = 0;
            while (coder.sweeps().unrefined() > 0 && stream.estimatedBytes() + ArchiveWriter.LARGEST_SPLIT < room) {
                int portion = Math.min(coder.sweeps().unrefined(), Math.max(1, BITS_AT_ONCE / bitsPerVertex));
                coder.sweeps().code(stream, portion);
                count += portion;
            }
            byte[] payload = SplitPayload.finish(stream);
            batches.add(BatchKind.PRECISION, payload, count, coder.sweeps().unrefined() > 0 ? from : shift);
            if (coder.sweeps().unrefined() > 0) afterBatch.run();
        }
    }

    /** Codes exact attributes of all wedges that are not exact yet. */
    void codeAttributes() throws MalformedStreamException {
        while (coder.sweeps().coarseWedges() > 0) {
            int room = room();
            RangeEncoder stream = new RangeEncoder();
            int count = 0;
            int widest = ArchiveWriter.LARGEST_SPLIT;
            while (coder.sweeps().coarseWedges() > 0 && stream.estimatedBytes() + 2 * widest < room) {
                int start = stream.estimatedBytes();
                coder.sweeps().codeAttributes(stream, 1);
                widest = Math.max(widest, stream.estimatedBytes() - start);
                count++;
            }
            batches.add(BatchKind.ATTRIBUTES, SplitPayload.finish(stream), count);
        }
    }
}
