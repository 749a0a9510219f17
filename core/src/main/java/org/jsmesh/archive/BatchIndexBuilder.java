package org.jsmesh.archive;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Collects the rows of a {@link BatchIndex} in file order. */
public final class BatchIndexBuilder {
    final List<BatchKind> kinds = new ArrayList<>();
    int[] bytes = new int[64];
    /** Splits of each batch, or vertices made more precise. */
    int[] patches = new int[64];

    int[] faces = new int[64];
    /** Vertices of the mesh after each batch. */
    int[] vertices = new int[64];

    int[] levels = new int[64];
    int[] passes = new int[64];
    int[] shifts = new int[64];
    /** Bits by which the coarsest position is known after each batch. */
    int[] precisionBits = new int[64];

    double[] errorMeans = new double[64];
    double[] errorQuantiles = new double[64];
    double[] errorBounds = new double[64];

    /**
     * Starts the next batch; its other values are 0 until set.
     *
     * @param kind of the payload
     * @param byteCount bytes with the checksum
     * @param patchCount splits in it, or vertices made more precise
     * @return this
     */
    public BatchIndexBuilder add(BatchKind kind, int byteCount, int patchCount) {
        int i = kinds.size();
        if (i == bytes.length) grow(2 * i);
        kinds.add(kind);
        bytes[i] = byteCount;
        patches[i] = patchCount;
        precisionBits[i] = 32;
        return this;
    }

    /**
     * Sets the counts of the mesh after the batch last added.
     *
     * @param faceCount faces
     * @param vertexCount vertices
     * @param errorMean mean distance to the original, in % of the bounding box's diagonal
     * @return this
     */
    public BatchIndexBuilder after(int faceCount, int vertexCount, double errorMean) {
        int i = kinds.size() - 1;
        faces[i] = faceCount;
        vertices[i] = vertexCount;
        errorMeans[i] = errorMean;
        return this;
    }

    /**
     * Sets the bound of the largest error after the batch last added, and the quantile, of which no more is known.
     *
     * @param errorBound in % of the bounding box's diagonal
     * @return this
     */
    public BatchIndexBuilder bounded(double errorBound) {
        int i = kinds.size() - 1;
        errorBounds[i] = errorBound;
        errorQuantiles[i] = errorBound;
        return this;
    }

    /**
     * Sets the level and the pass that the batch last added ends in.
     *
     * @param level 0 for the base, 1 for the coarsest level
     * @param pass counted from the base
     * @return this
     */
    public BatchIndexBuilder in(int level, int pass) {
        int i = kinds.size() - 1;
        levels[i] = level;
        passes[i] = pass;
        return this;
    }

    /**
     * Sets the precision of the positions.
     *
     * @param shift of those that the batch gives
     * @param bits by which the coarsest of all is known after it
     * @return this
     */
    public BatchIndexBuilder precise(int shift, int bits) {
        int i = kinds.size() - 1;
        shifts[i] = shift;
        precisionBits[i] = bits;
        return this;
    }

    /** {@return the number of batches added} */
    public int size() {
        return kinds.size();
    }

    /**
     * Sets the errors of a batch that was added.
     *
     * @param batch 0 to {@code size() - 1}
     * @param mean in % of the bounding box's diagonal
     * @param quantile in % of the bounding box's diagonal
     * @param bound in % of the bounding box's diagonal
     * @return this
     */
    public BatchIndexBuilder error(int batch, double mean, double quantile, double bound) {
        errorMeans[batch] = mean;
        errorQuantiles[batch] = quantile;
        errorBounds[batch] = bound;
        return this;
    }

    /**
     * Sets the quantile of the error of a batch that was added.
     *
     * @param batch 0 to {@code size() - 1}
     * @param quantile in % of the bounding box's diagonal
     * @return this
     */
    public BatchIndexBuilder quantile(int batch, double quantile) {
        errorQuantiles[batch] = quantile;
        return this;
    }

    /** {@return the index of the batches added; it does not change when more are} */
    public BatchIndex build() {
        if (kinds.isEmpty()) throw new IllegalArgumentException("an archive has at least one batch");
        return new BatchIndex(this);
    }

    /**
     * Kind of a batch that was added.
     *
     * @param batch 0 to {@code size() - 1}
     * @return what its payload is
     */
    public BatchKind kind(int batch) {
        return kinds.get(batch);
    }

    /**
     * Patches of a batch that was added.
     *
     * @param batch 0 to {@code size() - 1}
     * @return vertex splits, or vertices that a sweep refines
     */
    public int patches(int batch) {
        return patches[batch];
    }

    /**
     * Vertices of the mesh after a batch that was added.
     *
     * @param batch 0 to {@code size() - 1}
     * @return their number
     */
    public int vertices(int batch) {
        return vertices[batch];
    }

    /**
     * Precision after a batch that was added.
     *
     * @param batch 0 to {@code size() - 1}
     * @return bits by which the coarsest position is known, 32 when all are exact
     */
    public int precisionBits(int batch) {
        return precisionBits[batch];
    }

    private void grow(int size) {
        bytes = Arrays.copyOf(bytes, size);
        patches = Arrays.copyOf(patches, size);
        faces = Arrays.copyOf(faces, size);
        vertices = Arrays.copyOf(vertices, size);
        levels = Arrays.copyOf(levels, size);
        passes = Arrays.copyOf(passes, size);
        shifts = Arrays.copyOf(shifts, size);
        precisionBits = Arrays.copyOf(precisionBits, size);
        errorMeans = Arrays.copyOf(errorMeans, size);
        errorQuantiles = Arrays.copyOf(errorQuantiles, size);
        errorBounds = Arrays.copyOf(errorBounds, size);
    }
}
