package org.jsmesh.codec.lattice;

/**
 * Finds the {@link Translation} of decimal coordinates. Up to rounding, the moved coordinates are decimals as well,
 * plus a constant below the last digit. The offset itself shows only in the rounding, so the detector tries all offsets
 * that fit the constant.
 */
public final class TranslationDetector {
    private static final int MOST_CANDIDATES = 1 << 22;

    /**
     * A step of the decimals must be this many times coarser than float32; otherwise anything fits, and little can be
     * gained.
     */
    private static final double LEAST_GAIN = 16;

    private static final int PROBES = 48;
    private final int[] bits; // of positions, x y z
    private final int[] undone;
    private final int[] offsets = new int[3];

    private TranslationDetector(int[] bits) {
        this.bits = bits;
        undone = bits.clone();
    }

    /**
     * Finds the translation and undoes it.
     *
     * @param bits raw float32 bits of x, y, z of every vertex; receives the values before the move
     * @return {@link Translation#NONE} when none explains every coordinate
     */
    public static Translation undo(int[] bits) {
        TranslationDetector detector = new TranslationDetector(bits);
        double largest = 0;
        for (int b : bits) largest = Math.max(largest, Math.abs(Float.intBitsToFloat(b)));
        double step = detector.step(largest);
        if (step == 0) return Translation.NONE;
        for (int axis = 0; axis < 3; axis++) {
            if (!detector.findOffset(axis, step, largest)) return Translation.NONE;
        }
        System.arraycopy(detector.undone, 0, bits, 0, bits.length);
        return new Translation(detector.offsets);
    }

    /** The coarsest decimal step such that all coordinates of an axis are off by the same fraction of it, or 0. */
    private double step(double largest) {
        double ulp = ulp(largest);
        for (int digits = 2; digits <= 9; digits++) {
            double step = power(largest, digits);
            if (step < ulp * LEAST_GAIN) return 0;
            boolean fits = true;
            for (int axis = 0; axis < 3 && fits; axis++) fits = !Double.isNaN(fraction(axis, step, largest));
            if (fits) return step;
        }
        return 0;
    }

    /** The power of ten that leaves {@code largest} so many digits. */
    private static double power(double largest, int digits) {
        int exponent = -digits;
        for (double x = largest; x >= 1; x /= 10) exponent++;
        if (largest > 0 && largest < 1) for (double x = largest; x < 0.1; x *= 10) exponent--;
        double power = 1;
        for (int i = 0; i < Math.abs(exponent); i++) power *= 10;
        return exponent < 0 ? 1 / power : power;
    }

    /** The fraction of a step by which all coordinates of an axis are off; NaN when they do not agree. */
    private double fraction(int axis, double step, double largest) {
        double tolerance = ulp(largest) * 2 / step;
        double first = value(axis) / step;
        double part = nearest((first - Math.floor(first)) * 20) / 20;
        for (int i = axis; i < bits.length; i += 3) {
            double q = value(i) / step - part;
            if (Math.abs(q - nearest(q)) > tolerance) return Double.NaN;
        }
        return part;
    }

    private double value(int i) {
        return Float.intBitsToFloat(bits[i]);
    }

    private boolean findOffset(int axis, double step, double largest) {
        double part = fraction(axis, step, largest);
        int[] probes = probes(axis);
        int reach = (int) Math.min(MOST_CANDIDATES / 2, 4 * largest / step);
        for (int n = 0; n <= 2 * reach; n++) {
            double units = ((n & 1) == 0 ? n >> 1 : -(n + 1 >> 1)) + part;
            int offsetBits = Float.floatToIntBits((float) decimal(units, step));
            float offset = Float.intBitsToFloat(offsetBits);
            if (explains(probes, axis, offset, step) && undoAll(axis, offset, step)) {
                offsets[axis] = offsetBits;
                return true;
            }
        }
        return false;
    }

    /** The coordinates closest to 0 tell most: there the sum's own rounding hides least. */
    private int[] probes(int axis) {
        int count = Math.min(PROBES, bits.length / 3);
        int[] probes = new int[count];
        int stride = bits.length / 3 / count;
        for (int p = 0; p < count; p++) {
            int best = 3 * p * stride + axis;
            for (int i = best; i < 3 * (p + 1) * stride; i += 3)
                if (Math.abs(value(i)) < Math.abs(value(best))) best = i;
            probes[p] = best;
        }
        return probes;
    }

    private boolean explains(int[] probes, int axis, float offset, double step) {
        for (int i : probes) if (undo(i, offset, step) == Integer.MIN_VALUE) return false;
        return true;
    }

    private boolean undoAll(int axis, float offset, double step) {
        for (int i = axis; i < bits.length; i += 3) {
            undone[i] = undo(i, offset, step);
            if (undone[i] == Integer.MIN_VALUE) return false;
        }
        return true;
    }

    /** Bits of the decimal that the move turned into a coordinate, or those of −0 when there is none. */
    private int undo(int i, float offset, double step) {
        double units = nearest((value(i) - offset) / step);
        int before = units == 0 ? 0 : Float.floatToRawIntBits((float) decimal(units, step));
        float moved = (float) ((double) Float.intBitsToFloat(before) + offset);
        return Float.floatToRawIntBits(moved) == bits[i] ? before : Integer.MIN_VALUE;
    }

    /** A quotient where the step is below 1: 10^-k is no double, 10^k is. */
    private static double decimal(double units, double step) {
        return step < 1 ? units / nearest(1 / step) : units * step;
    }

    private static double nearest(double x) {
        return Math.floor(x + .5);
    }

    /** The distance between float32 numbers of this size. */
    private static double ulp(double size) {
        int exponent = Float.floatToRawIntBits((float) size) & 0x7f800000;
        return (double) Float.intBitsToFloat(exponent) / (1 << 23);
    }
}
