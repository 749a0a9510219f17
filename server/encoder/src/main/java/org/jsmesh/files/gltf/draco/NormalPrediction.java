package org.jsmesh.files.gltf.draco;

import java.util.Arrays;
import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/** Predicts normals from the areas of the faces around a vertex. */
final class NormalPrediction extends Prediction {
    private static final long MOST = 1 << 29;

    private final Octahedron octahedron;
    private final ValueOrder order;
    private final Positions positions;
    private final long[] center = new long[3];
    private final long[] next = new long[3];
    private final long[] previous = new long[3];
    private RansBits negated;

    NormalPrediction(Octahedron octahedron, ValueOrder order, Positions positions) {
        super(octahedron, 2);
        this.octahedron = octahedron;
        this.order = order;
        this.positions = positions;
    }

    @Override
    void readData(PackedBytes in) throws PackedException {
        super.readData(in);
        negated = new RansBits(in);
    }

    @Override
    void restore(int[] values) throws PackedException {
        int[] predicted = new int[2];
        long[] normal = new long[3];
        for (int entry = 0; entry < order.corners().length; entry++) {
            predict(order.corners()[entry], normal);
            octahedron.toPoint(normal, negated.next(), predicted);
            correction.correct(predicted, 0, values, 2 * entry);
        }
    }

    private void predict(int start, long[] normal) throws PackedException {
        CornerTable table = order.table();
        positions.get(start, center);
        Arrays.fill(normal, 0);
        int corner = start;
        do {
            addArea(corner, normal);
            corner = table.swingLeft(corner);
        } while (corner != CornerTable.NONE && corner != start);
        if (corner == CornerTable.NONE) {
            for (corner = table.swingRight(start); corner != CornerTable.NONE; corner = table.swingRight(corner)) {
                addArea(corner, normal);
            }
        }
        long quotient = sum(normal) / MOST;
        if (quotient > 0) for (int i = 0; i < 3; i++) normal[i] /= quotient;
        // Encoders keep 32 bits.
        for (int i = 0; i < 3; i++) normal[i] = (int) normal[i];
    }

    private void addArea(int corner, long[] normal) throws PackedException {
        positions.get(CornerTable.next(corner), next);
        positions.get(CornerTable.previous(corner), previous);
        for (int i = 0; i < 3; i++) {
            next[i] -= center[i];
            previous[i] -= center[i];
        }
        normal[0] += next[1] * previous[2] - next[2] * previous[1];
        normal[1] += next[2] * previous[0] - next[0] * previous[2];
        normal[2] += next[0] * previous[1] - next[1] * previous[0];
    }

    private static long sum(long[] vector) {
        long sum = 0;
        for (long v : vector) {
            long size = Math.abs(v);
            if (sum > Long.MAX_VALUE - size) return Long.MAX_VALUE;
            sum += size;
        }
        return sum;
    }
}
