package org.jsmesh.archive;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Collects the rows of a {@link BatchIndex} in file order. */
public final class BatchIndexBuilder {
    final List<BatchKind> kinds = new ArrayList<>();
    int[] bytes = new int[64];
    int[] patches = new int[64];
    int[] faces = new int[64];
    int[] vertices = new int[64];
    int[] levels = new int[64];
    int[] passes = new int[64];
    int[] shifts = new int[64];
    int[] precisionBits = new int[64];
    double[] errorMeans = new double[64];

    /** Starts the next batch; its other values are 0 until set. */
    public BatchIndexBuilder add(BatchKind kind, int byteCount, int patchCount) {
        int i = kinds.size();
        if (i == bytes.length) grow(2 * i);
        kinds.add(kind);
        bytes[i] = byteCount;
        patches[i] = patchCount;
        precisionBits[i] = 32;
        return this;
    }

    /** Counts of the mesh after the batch last added. */
    public BatchIndexBuilder after(int faceCount, int vertexCount, double errorMean) {
        int i = kinds.size() - 1;
        faces[i] = faceCount;
        vertices[i] = vertexCount;
        errorMeans[i] = errorMean;
        return this;
    }

    /** Place of the batch last added within the simplification. */
    public BatchIndexBuilder in(int level, int pass) {
        int i = kinds.size() - 1;
        levels[i] = level;
        passes[i] = pass;
        return this;
    }

    /**
     * Precision of the positions.
     *
     * @param shift of those that the batch gives
     * @param bits by which the coarsest of all is known after it
     */
    BatchIndexBuilder precise(int shift, int bits) {
        int i = kinds.size() - 1;
        shifts[i] = shift;
        precisionBits[i] = bits;
        return this;
    }

    BatchKind kindOfLast() {
        return kinds.get(kinds.size() - 1);
    }

    int size() {
        return kinds.size();
    }

    /**
     * Sets the errors of the batches from {@code from} on, at least the second: from {@code before} to {@code after} they fall with a power of the number of vertices; where that stays the
     * same, or nothing is left of the error, as the patches are applied.
     */
    void spreadError(int from, double before, double after) {
        int last = kinds.size() - 1;
        if (after > 0 && last >= from && vertices[last] > vertices[from - 1]) {
            double grown = StrictMath.log((double) vertices[last] / vertices[from - 1]);
            double power = StrictMath.log(before / after) / grown;
            for (int i = from; i <= last; i++)
                errorMeans[i] = before * StrictMath.pow((double) vertices[from - 1] / vertices[i], power);
            return;
        }
        int total = 0;
        for (int i = from; i <= last; i++) total += patches[i];
        int done = 0;
        for (int i = from; i <= last; i++) {
            done += patches[i];
            double part = total == 0 ? 1 : (double) done / total;
            errorMeans[i] = before * (1 - part) + after * part;
        }
    }

    public BatchIndex build() {
        if (kinds.isEmpty()) throw new IllegalArgumentException("an archive has at least one batch");
        return new BatchIndex(this);
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
    }
}
