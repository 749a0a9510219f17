package org.jsmesh.mesh;

/**
 * Positions in double precision: an origin, float32 offsets from it, to compute and to draw with, and the exact
 * coordinates. Vertices far from the origin of their coordinates, such as those of a map projection, would fall
 * together in float32.
 */
final class DoublePositions {
    final double[] origin = new double[3];
    final float[] offsets;
    final double[] exact;

    /**
     * @param exact x, y, z of each vertex
     * @throws IllegalArgumentException when offsets are beyond float32
     */
    DoublePositions(double[] exact) {
        this.exact = exact;
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int i = 0; i < exact.length; i++) {
            if (!isFinite(exact[i])) continue;
            low[i % 3] = Math.min(low[i % 3], exact[i]);
            high[i % 3] = Math.max(high[i % 3], exact[i]);
        }
        double extent = Math.max(high[0] - low[0], Math.max(high[1] - low[1], high[2] - low[2]));
        for (int a = 0; a < 3; a++) origin[a] = origin(low[a], high[a], extent);
        offsets = new float[exact.length];
        for (int i = 0; i < exact.length; i++) offsets[i] = offset(exact[i], origin[i % 3]);
    }

    /** The offset of a coordinate from an origin. */
    static float offset(double exact, double origin) {
        return rounded(origin == 0 ? exact : exact - origin);
    }

    /** The closest float32; through bits: in JavaScript, nothing else rounds. */
    private static float rounded(double x) {
        return Float.intBitsToFloat(Float.floatToIntBits((float) x));
    }

    /**
     * 0 for coordinates that lie around it, else the middle of the box, rounded to a power of ten that is not longer
     * than the box.
     */
    private static double origin(double low, double high, double extent) {
        double most = Math.max(Math.abs(low), Math.abs(high));
        if (!(most > 2 * extent) || !isFinite(extent)) return 0;
        if (extent == 0) return low;
        double middle = low + (high - low) / 2;
        double power = 1;
        while (power > extent) power /= 10;
        while (power * 10 <= extent) power *= 10;
        if (power >= 1) return Math.floor(middle / power + .5) * power;
        double parts = 1; // a quotient by a whole power of ten is the double closest to the decimal
        while (1 / parts > extent) parts *= 10;
        return Math.floor(middle * parts + .5) / parts;
    }

    private static boolean isFinite(double x) {
        return Math.abs(x) <= Double.MAX_VALUE;
    }

    /** Does float32 hold a number, bit for bit? */
    static boolean isFloat(double x) {
        return Double.doubleToRawLongBits(rounded(x)) == Double.doubleToRawLongBits(x);
    }

    /** The same numbers as float32, or null when one of them is none. */
    static float[] asFloats(double[] numbers) {
        float[] floats = new float[numbers.length];
        for (int i = 0; i < numbers.length; i++) {
            if (!isFloat(numbers[i]) && numbers[i] == numbers[i]) return null;
            floats[i] = rounded(numbers[i]);
        }
        return floats;
    }
}
