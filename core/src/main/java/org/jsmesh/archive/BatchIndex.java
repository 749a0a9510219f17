package org.jsmesh.archive;

import java.util.function.IntToDoubleFunction;

/**
 * What each batch of an archive is and what the mesh is after it. Batches tile the file. Batch 0 is the opening of the
 * file, with the first part of header and index, and the base. Until the rest of the header has come, the index ends
 * with the batch that holds it. Immutable.
 */
public final class BatchIndex {
    private static final int CHECKSUM_BYTES = 4;

    /** Bytes that a client asks for before it knows the index; see {@link #firstBytes}. */
    public static final int FIRST_FILE_BYTES = 8192;

    /** Share of the surface that is within {@link #errorQuantile} of the original. */
    public static final double QUANTILE = 0.999;

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
    private final double[] errorQuantiles;
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
        errorQuantiles = java.util.Arrays.copyOf(b.errorQuantiles, n);
        errorBounds = java.util.Arrays.copyOf(b.errorBounds, n);
    }

    /** {@return the number of batches, at least 1} */
    public int size() {
        return ends.length;
    }

    /**
     * Tells what a batch holds.
     *
     * @param batch 0 to {@code size() - 1}
     * @return the kind of its payload
     */
    public BatchKind kind(int batch) {
        return kinds[batch];
    }

    /**
     * Tells how many bytes of a batch are not its checksum, which comes last.
     *
     * @param bytes of the batch, as {@link #bytes} has them
     * @return bytes of the payload: of a poster or a texture verbatim those of a file, or of a part of one
     */
    public static int payloadBytes(int bytes) {
        return bytes - CHECKSUM_BYTES;
    }

    /** {@return the batch with the poster, whose payload is a JPEG file; −1 when there is none} */
    public int poster() {
        for (int i = kinds.length - 1; i >= 0; i--) if (kinds[i] == BatchKind.POSTER) return i;
        return -1;
    }

    /**
     * Finds where a batch begins.
     *
     * @param batch 0 to {@code size() - 1}
     * @return its first byte, counted from the start of the file
     */
    public long offset(int batch) {
        return batch == 0 ? 0 : ends[batch - 1];
    }

    /**
     * Tells how long a batch is.
     *
     * @param batch 0 to {@code size() - 1}
     * @return its bytes with its checksum
     */
    public int bytes(int batch) {
        return (int) (ends[batch] - offset(batch));
    }

    /**
     * Finds where a batch ends.
     *
     * @param batch 0 to {@code size() - 1}
     * @return offset of the byte after it
     */
    public long end(int batch) {
        return ends[batch];
    }

    /**
     * Tells how much a batch refines.
     *
     * @param batch 0 to {@code size() - 1}
     * @return vertex splits in it (components count as splits), vertices whose positions it makes more precise, or
     *     wedges whose attributes it makes exact; 0 for other kinds
     */
    public int patches(int batch) {
        return patches[batch];
    }

    /**
     * Tells how many faces there are after a batch.
     *
     * @param batch 0 to {@code size() - 1}
     * @return faces of the mesh
     */
    public int faces(int batch) {
        return faces[batch];
    }

    /**
     * Tells how many vertices there are after a batch.
     *
     * @param batch 0 to {@code size() - 1}
     * @return vertices of the mesh
     */
    public int vertices(int batch) {
        return vertices[batch];
    }

    /**
     * Tells the level that a batch ends in.
     *
     * @param batch 0 to {@code size() - 1}
     * @return 1 for the coarsest level; 0 for the base
     */
    public int level(int batch) {
        return levels[batch];
    }

    /**
     * Tells the pass that a batch ends in.
     *
     * @param batch 0 to {@code size() - 1}
     * @return its number, counted from the base; 0 for the base itself
     */
    public int pass(int batch) {
        return passes[batch];
    }

    /**
     * Tells how coarse the positions are that a batch gives: multiples of 2<sup>shift</sup> cells of their lattice.
     *
     * @param batch 0 to {@code size() - 1}
     * @return the shift; 0 when positions are exact
     */
    public int shift(int batch) {
        return shifts[batch];
    }

    /**
     * Tells how precise positions are after a batch.
     *
     * @param batch 0 to {@code size() - 1}
     * @return bits of the longest side of the bounding box by which the coarsest position is known; 32 when all are
     *     exact
     */
    public int precisionBits(int batch) {
        return precisionBits[batch];
    }

    /**
     * Tells the mean distance to the original after a batch.
     *
     * @param batch 0 to {@code size() - 1}
     * @return in % of the bounding box's diagonal
     */
    public double errorMean(int batch) {
        return errorMeans[batch];
    }

    /**
     * Tells the distance to the original that {@value #QUANTILE} of the surface does not exceed after a batch, in
     * either direction: what decides whether the mesh looks like the original at some size. A bad spot may be off by
     * more, up to {@link #errorBound}. It is measured with many points, not proven: see {@code docs/format.md}.
     *
     * @param batch 0 to {@code size() - 1}
     * @return in % of the bounding box's diagonal, from {@link #errorMean} to {@link #errorBound}; it never rises from
     *     batch to batch. Until the rest of the header has come, and in archives that do not tell, it is the bound
     */
    public double errorQuantile(int batch) {
        return errorQuantiles[batch];
    }

    /**
     * Bounds the distance to the original after a batch. No point of the mesh is expected to be further away from the
     * original, nor any point of the original from the mesh. It is estimated from above, not proven: see
     * {@code docs/format.md}.
     *
     * @param batch 0 to {@code size() - 1}
     * @return in % of the bounding box's diagonal
     */
    public double errorBound(int batch) {
        return errorBounds[batch];
    }

    /**
     * Finds the first batch after which an error does not exceed a value.
     *
     * @param error of each batch, which never rises: {@link #errorMean}, {@link #errorQuantile} or {@link #errorBound}
     * @param most in % of the bounding box's diagonal; not negative
     * @return the batch; the last one if the value is exceeded up to there
     */
    public int firstWithin(IntToDoubleFunction error, double most) {
        int batch = 0;
        while (batch < ends.length - 1 && error.applyAsDouble(batch) > most) batch++;
        return batch;
    }

    /** {@return the bytes of all batches in the index: of the whole archive, once the header is whole} */
    public long archiveBytes() {
        return ends[ends.length - 1];
    }

    /**
     * Measures what a client asks for at once, before it knows the index: the base, and as many batches after it as end
     * within {@value #FIRST_FILE_BYTES} bytes.
     *
     * @return bytes from the start of the file
     */
    public int firstBytes() {
        return (int) ends[Math.max(1, batchesWithin(FIRST_FILE_BYTES)) - 1];
    }

    /**
     * Counts the batches that a prefix of the file holds.
     *
     * @param bytes length of the prefix
     * @return number of leading batches that lie wholly within it
     */
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
