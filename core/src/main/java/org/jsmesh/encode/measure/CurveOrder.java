package org.jsmesh.encode.measure;

/**
 * The order of triangles along a Z-order curve through a grid of 1024³ cells over their box: Morton 1966. Sorted by
 * counting, in linear time.
 */
final class CurveOrder {
    private static final int BITS = 10; // per axis, and per round of counting
    private static final int CELLS = 1 << BITS;
    private static final int[] SPREAD = new int[CELLS]; // numbers with two zeros behind each bit

    static {
        for (int i = 0; i < CELLS; i++) {
            for (int bit = 0; bit < BITS; bit++) SPREAD[i] |= (i >> bit & 1) << 3 * bit;
        }
    }

    private CurveOrder() {}

    /** The numbers of the triangles in the order of the curve; those of one cell keep their order. */
    static int[] of(float[] positions, int[] triangles, int size) {
        int[] keys = keys(positions, triangles, size);
        int[] order = null;
        for (int shift = 0; shift < 3 * BITS; shift += BITS) order = sort(keys, order, shift);
        return order;
    }

    private static int[] keys(float[] p, int[] triangles, int size) {
        float[] low = {Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY};
        float[] high = {Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY};
        int corners = 3 * size;
        for (int axis = 0; axis < 3; axis++) {
            float least = low[axis];
            float most = high[axis];
            for (int i = 0; i < corners; i++) {
                float x = p[3 * triangles[i] + axis];
                if (x < least) least = x;
                if (x > most) most = x;
            }
            low[axis] = least;
            high[axis] = most;
        }
        double side = 0;
        for (int axis = 0; axis < 3; axis++) side = Math.max(side, (double) high[axis] - low[axis]);
        double scale = side > 0 ? CELLS / (3 * side) : 0; // sums of three coordinates become cells
        int[] keys = new int[size];
        for (int i = 0; i < size; i++) {
            int a = 3 * triangles[3 * i];
            int b = 3 * triangles[3 * i + 1];
            int c = 3 * triangles[3 * i + 2];
            keys[i] = cell((double) p[a] + p[b] + p[c], low[0], scale)
                    | cell((double) p[a + 1] + p[b + 1] + p[c + 1], low[1], scale) << 1
                    | cell((double) p[a + 2] + p[b + 2] + p[c + 2], low[2], scale) << 2;
        }
        return keys;
    }

    private static int cell(double sum, float low, double scale) {
        int cell = (int) ((sum - 3.0 * low) * scale);
        return SPREAD[cell < 0 ? 0 : cell < CELLS ? cell : CELLS - 1];
    }

    /**
     * Sorts an order, or the natural one if null, by some bits of the keys. Triangles with the same bits keep their
     * order.
     */
    private static int[] sort(int[] keys, int[] order, int shift) {
        int n = keys.length;
        int[] starts = new int[CELLS + 1];
        for (int key : keys) starts[(key >> shift & CELLS - 1) + 1]++;
        for (int i = 0; i < CELLS; i++) starts[i + 1] += starts[i];
        int[] sorted = new int[n];
        for (int i = 0; i < n; i++) {
            int item = order == null ? i : order[i];
            sorted[starts[keys[item] >> shift & CELLS - 1]++] = item;
        }
        return sorted;
    }
}
