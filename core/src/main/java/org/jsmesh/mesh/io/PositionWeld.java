package org.jsmesh.mesh.io;

/**
 * Merges vertices with bit-equal positions. The new ids keep the order of first sight. −0.0 and +0.0 are different
 * positions.
 */
final class PositionWeld {
    private final int[] vertices;
    private final TupleIndex distinct; // words of x, y, z

    private PositionWeld(int[] vertices, TupleIndex distinct) {
        this.vertices = vertices;
        this.distinct = distinct;
    }

    static PositionWeld of(float[] positions) {
        int[] vertices = new int[positions.length / 3];
        TupleIndex index = new TupleIndex(3);
        int[] key = new int[3];
        for (int v = 0; v < vertices.length; v++) {
            for (int i = 0; i < 3; i++) key[i] = Float.floatToRawIntBits(positions[3 * v + i]);
            vertices[v] = index.intern(key, 0);
        }
        return new PositionWeld(vertices, index);
    }

    static PositionWeld of(double[] positions) {
        int[] vertices = new int[positions.length / 3];
        TupleIndex index = new TupleIndex(6);
        int[] key = new int[6];
        for (int v = 0; v < vertices.length; v++) {
            for (int i = 0; i < 3; i++) {
                long bits = Double.doubleToRawLongBits(positions[3 * v + i]);
                key[2 * i] = (int) bits;
                key[2 * i + 1] = (int) (bits >>> 32);
            }
            vertices[v] = index.intern(key, 0);
        }
        return new PositionWeld(vertices, index);
    }

    int vertex(int original) {
        return vertices[original];
    }

    /** Of each distinct vertex, where the positions are float32. */
    float[] positions() {
        float[] positions = new float[3 * distinct.size()];
        for (int i = 0; i < positions.length; i++) positions[i] = Float.intBitsToFloat(distinct.value(i / 3, i % 3));
        return positions;
    }

    /** Of each distinct vertex, where the positions are doubles. */
    double[] exactPositions() {
        double[] positions = new double[3 * distinct.size()];
        for (int i = 0; i < positions.length; i++) {
            long low = distinct.value(i / 3, i % 3 * 2) & 0xffffffffL;
            positions[i] = Double.longBitsToDouble((long) distinct.value(i / 3, i % 3 * 2 + 1) << 32 | low);
        }
        return positions;
    }
}
