package org.jsmesh.codec.exact;

import org.jsmesh.codec.entropy.BinaryCoder;

/**
 * Codes numbers in double precision, given the float32 offsets that the rest of the archive brings: which decimal, or
 * which double, of those that are rounded to the offset. These are the last bits of measurements and mostly noise, so
 * they are coded as equally probable. One instance per column of numbers.
 */
final class ExactCoder {
    private static final long MAGNITUDE = Long.MAX_VALUE;

    /** More than the rounding of an offset to float32 can be off because of its own computation. */
    private static final double TOLERANCE = 1.0 / (1 << 20);

    /** The same, in parts of the numbers that were subtracted. */
    private static final double PRECISION = 1.0 / (1L << 51);

    private final ExactForm form;
    private final int[] exception = BinaryCoder.newContexts(1);
    private final int[] same = BinaryCoder.newContexts(2);

    ExactCoder(ExactForm form) {
        this.form = form;
    }

    /**
     * Codes a number.
     *
     * @param offset its float32 offset, which is known
     * @param x the number; of no meaning to a decoder
     */
    double code(BinaryCoder coder, int component, float offset, double x) {
        if (form.isWhole) return form.number(component, offset);
        double units = coder.isEncoder() ? form.units(component, x) : 0;
        if (form.isBinary() || form.hasExceptions && coder.bit(exception, 0, units == units ? 0 : 1) != 0)
            return codeBinary(coder, component, offset, x);
        int nearest = form.nearest(offset);
        int spread = form.spread(offset);
        if (spread == 0) return form.number(component, offset, nearest);
        int low = Math.max(nearest - spread, Integer.MIN_VALUE / 2);
        int place = coder.uniform((int) (units - form.origins[component]) - low, 2 * spread + 1);
        return form.number(component, offset, low + place);
    }

    private double codeBinary(BinaryCoder coder, int component, float offset, double x) {
        double origin = form.origin(component);
        double center = origin == 0 ? offset : ExactForm.finite(origin + offset);
        boolean isCenter = Double.doubleToRawLongBits(x) == Double.doubleToRawLongBits(center);
        if (coder.bit(same, offset == 0 ? 0 : 1, isCenter ? 1 : 0) != 0) return center;
        double margin =
                ExactForm.halfStep(offset) * (1 + TOLERANCE) + (Math.abs(origin) + Math.abs(center)) * PRECISION;
        boolean isLargest = (Float.floatToRawIntBits(offset) & 0x7fffffff) == ExactForm.LARGEST_FLOAT;
        long low = place(isLargest && offset < 0 ? -Double.MAX_VALUE : ExactForm.finite(center - margin));
        long high = place(isLargest && offset > 0 ? Double.MAX_VALUE : ExactForm.finite(center + margin));
        return number(low + codeBelow(coder, place(x) - low, high - low));
    }

    /** The place of a number among all doubles in their order, −0 before 0, without the bits that are 0 in all. */
    private long place(double x) {
        long bits = Double.doubleToRawLongBits(x);
        long magnitude = (bits & MAGNITUDE) >>> form.zeros;
        return bits < 0 ? -1 - magnitude : magnitude;
    }

    private double number(long place) {
        return Double.longBitsToDouble(place < 0 ? -1 - place << form.zeros | ~MAGNITUDE : place << form.zeros);
    }

    /** Codes a value of 0 to {@code most}, all equally probable. */
    private static long codeBelow(BinaryCoder coder, long value, long most) {
        if (most < Integer.MAX_VALUE) return coder.uniform((int) value, (int) most + 1);
        long high = coder.uniform((int) (value >>> 32), (int) (most >>> 32) + 1);
        return Math.min(high << 32 | coder.raw((int) value, 32) & 0xffffffffL, most);
    }
}
