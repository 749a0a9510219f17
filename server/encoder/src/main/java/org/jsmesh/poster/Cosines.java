package org.jsmesh.poster;

/** The discrete cosine transform of 8 x 8 values (ITU T.81, A.3.3), with integers. */
final class Cosines {
    /** Parts of 1 in which coefficients are given. */
    static final int SCALE = 16;

    private static final int SIDE = 8;
    private static final int BITS = 12;
    /** How each value counts for each frequency, in 4096ths. */
    private static final int[] WEIGHTS = new int[SIDE * SIDE];

    static {
        for (int i = 0; i < WEIGHTS.length; i++) {
            double cosine = StrictMath.cos((2 * (i % SIDE) + 1) * (i / SIDE) * Math.PI / 16);
            WEIGHTS[i] = (int) Math.rint((1 << BITS) * cosine / 2 * (i < SIDE ? Math.sqrt(.5) : 1));
        }
    }

    private Cosines() {}

    /**
     * Transforms a block of a plane.
     *
     * @param to takes 64 coefficients, row by row, from {@code at} on
     */
    static void transform(int[] plane, int width, int left, int top, int[] to, int at) {
        int[] rows = new int[SIDE * SIDE];
        for (int i = 0; i < rows.length; i++) {
            int from = (top + i / SIDE) * width + left;
            int sum = 0;
            for (int x = 0; x < SIDE; x++) sum += WEIGHTS[i % SIDE * SIDE + x] * plane[from + x];
            rows[i] = sum + (1 << BITS - 5) >> BITS - 4; // in SCALEths
        }
        for (int i = 0; i < rows.length; i++) {
            int sum = 0;
            for (int y = 0; y < SIDE; y++) sum += WEIGHTS[i / SIDE * SIDE + y] * rows[y * SIDE + i % SIDE];
            to[at + i] = sum + (1 << BITS - 1) >> BITS;
        }
    }
}
