package org.jsmesh.mesh.io;

/**
 * Merges vertices with bit-equal positions. The new ids keep the order of first sight. −0.0 and +0.0 are different
 * positions.
 */
final class PositionWeld {
    private final int[] vertices;
    private final float[] positions;

    private PositionWeld(int[] vertices, float[] positions) {
        this.vertices = vertices;
        this.positions = positions;
    }

    static PositionWeld of(float[] positions) {
        int[] vertices = new int[positions.length / 3];
        TupleIndex index = new TupleIndex(3);
        int[] key = new int[3];
        for (int v = 0; v < vertices.length; v++) {
            for (int i = 0; i < 3; i++) key[i] = Float.floatToRawIntBits(positions[3 * v + i]);
            vertices[v] = index.intern(key, 0);
        }
        float[] distinct = new float[3 * index.size()];
        for (int i = 0; i < distinct.length; i++) distinct[i] = Float.intBitsToFloat(index.value(i / 3, i % 3));
        return new PositionWeld(vertices, distinct);
    }

    int vertex(int original) {
        return vertices[original];
    }

    float[] positions() {
        return positions;
    }
}
