package org.jsmesh.mesh;

/**
 * The bits of positions, to compare and to sort by: a word per axis, or in double precision two, the low bits first.
 */
final class PositionBits {
    private PositionBits() {}

    /** Puts the bits of a vertex into an array and returns the place behind them. */
    static int put(int[] words, int at, Mesh mesh, int vertex, boolean wide) {
        for (int a = 0; a < 3; a++) {
            if (!wide && !mesh.isDouble()) {
                words[at++] = Float.floatToRawIntBits(mesh.positions()[3 * vertex + a]);
                continue;
            }
            double x = mesh.coordinate(vertex, a);
            if (!wide) {
                words[at++] = Float.floatToRawIntBits((float) x); // the same number: nothing is rounded
                continue;
            }
            long bits = Double.doubleToRawLongBits(x);
            words[at++] = (int) bits;
            words[at++] = (int) (bits >>> 32);
        }
        return at;
    }

    /** Words that {@link #put} fills. */
    static int words(boolean wide) {
        return wide ? 6 : 3;
    }
}
