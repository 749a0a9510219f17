package org.jsmesh.archive;

/**
 * What each batch of an archive is and what the mesh is after it. Batches tile the file. Batch 0 is the opening of the
 * file, with the first part of header and index, and the base. Until the rest of the header has come, the index ends
 * with the batch that holds it. Immutable.
 */
public final class BatchIndex {
    private final BatchKind[] kinds;
    private final long[] ends;
    private final int[] patches;
    private final int[] faces;
    private final int[] vertices;
    private final int[] levels;
    private final int[] passes;
    private final int[] shifts;
    private final int[] precisionBits;
    private final double[] errorMeans;
    private final double[] errorBounds;

    BatchIndex(BatchIndexBuilder b) {
        kinds = b.kinds.toArray(new BatchKind[0]);
        int n = kinds.length;
        ends = new long[n];
        long end = 0;
        for (int i = 0; i < n; i++) ends[i] = end += b.bytes[i];
        patches = java.util.Arrays.copyOf(b.patches, n);
        faces = java.util.Arrays.copyOf(b.faces, n);
        vertices = java.util.Arrays.copyOf(b.vertices, n);
        levels = java.util.Arrays.copyOf(b.levels, n);
        passes = java.util.Arrays.copyOf(b.passes, n);
        shifts = java.util.Arrays.copyOf(b.shifts, n);
        precisionBits = java.util.Arrays.copyOf(b.precisionBits, n);
        errorMeans = java.util.Arrays.copyOf(b.errorMeans, n);
        errorBounds = java.util.Arrays.copyOf(b.errorBounds, n);
    }

    /** Number of batches, at least 1. */
    public int size() {
        return ends.length;
    }

    public BatchKind kind(int batch) {
        return kinds[batch];
    }

    /** First byte of the batch, from the start of the file. */
    public long offset(int batch) {
        return batch == 0 ? 0 : ends[batch - 1];
    }

    /** Bytes of the batch with its checksum. */
    public int bytes(int batch) {
        return (int) (ends[batch] - offset(batch));
    }

    /** Offset of the byte after the batch. */
    public long end(int batch) {
        return ends[batch];
    }

    /**
     * Vertex splits in the batch (components count as splits), vertices whose positions it makes more precise, or
     * wedges whose attributes it makes exact; 0 for other kinds.
     */
    public int patches(int batch) {
        return patches[batch];
    }

    /** Faces of the mesh after the batch. */
    public int faces(int batch) {
        return faces[batch];
    }

    /** Vertices of the mesh after the batch. */
    public int vertices(int batch) {
        return vertices[batch];
    }

    /** Level that the batch ends in: 1 is the coarsest, the base has 0. */
    public int level(int batch) {
        return levels[batch];
    }

    /** Pass that the batch ends in, counted from the base; 0 for the base itself. */
    public int pass(int batch) {
        return passes[batch];
    }

    /** The batch gives positions as multiples of 2<sup>shift</sup> cells of their lattice; 0: exactly. */
    public int shift(int batch) {
        return shifts[batch];
    }

    /**
     * Bits of the longest side of the bounding box by which the coarsest position is known after the batch; 32 when all
     * are exact.
     */
    public int precisionBits(int batch) {
        return precisionBits[batch];
    }

    /** Mean distance to the original after the batch, in % of the bounding box's diagonal. */
    public double errorMean(int batch) {
        return errorMeans[batch];
    }

    /**
     * Distance that no point of the mesh after the batch is expected to exceed from the original, nor any point of the
     * original from the mesh; in % of the bounding box's diagonal. It is estimated from above, not proven: see the
     * description of the format.
     */
    public double errorBound(int batch) {
        return errorBounds[batch];
    }

    /** Bytes of all batches in the index: of the whole archive, once the header is whole. */
    public long archiveBytes() {
        return ends[ends.length - 1];
    }

    /** Number of leading batches that lie wholly within the first {@code bytes} bytes. */
    public int batchesWithin(long bytes) {
        int low = 0;
        int high = ends.length;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (ends[middle] <= bytes) low = middle + 1;
            else high = middle;
        }
        return low;
    }
}
