package org.jsmesh.codec.exact;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * How numbers in double precision become float32 numbers, which the codec takes, and back. A number is the origin of
 * its component plus an offset, and the offset rounded to float32 is coded. What the rounding loses follows later (see
 * {@link ExactCoder}).
 *
 * <p>Most numbers were once decimals. Then a number is a whole count of units 10^−places, divided by the whole power of
 * ten: IEEE division gives the double closest to the decimal. So are the origin and the offset counts of units.
 * Otherwise numbers are <em>binary</em>: any doubles.
 */
public final class ExactForm {
    /** In place of decimals: any doubles. */
    static final int BINARY = -1;

    static final int MOST_PLACES = 15;

    /** Offsets are smaller than this, in units. */
    static final double MOST_UNITS = 1 << 30;

    /** Whole numbers below this are doubles, each. */
    private static final double MOST_WHOLE = 9007199254740992.0;

    /** Bits of the largest float32 number. */
    static final int LARGEST_FLOAT = 0x7f7fffff;

    private static final int MOST_ZEROS = 52;

    final int places;
    final double scale; // 10^places
    final double[] origins; // in units, or where binary in numbers
    final boolean hasExceptions; // are some numbers no such decimals?
    final int zeros; // trailing zero bits that all binary numbers have
    final boolean isWhole; // do float32 offsets tell all?

    ExactForm(int places, double[] origins, boolean hasExceptions, int zeros, boolean isWhole) {
        this.places = places;
        this.origins = origins;
        this.hasExceptions = hasExceptions;
        this.zeros = zeros;
        this.isWhole = isWhole;
        scale = power(Math.max(0, places));
    }

    /** Whole numbers that float32 holds. */
    static ExactForm whole(int components) {
        return new ExactForm(0, new double[components], false, 0, true);
    }

    static double power(int places) {
        double power = 1;
        for (int i = 0; i < places; i++) power *= 10;
        return power;
    }

    boolean isBinary() {
        return places == BINARY;
    }

    /** What the offsets of a component count from. */
    double origin(int component) {
        return isBinary() ? origins[component] : origins[component] / scale;
    }

    /** What the offsets of all components count from. */
    double[] originsAsNumbers() {
        double[] numbers = new double[origins.length];
        for (int c = 0; c < numbers.length; c++) numbers[c] = origin(c);
        return numbers;
    }

    /** The units of a decimal; NaN when the number is none. −0 is a decimal where the origin is 0. */
    double units(int component, double x) {
        return isBinary() ? Double.NaN : units(x, scale, origins[component]);
    }

    static double units(double x, double scale, double origin) {
        double magnitude = Math.floor(Math.abs(x) * scale + .5);
        if (!(magnitude < MOST_WHOLE) || Double.compare(magnitude / scale, Math.abs(x)) != 0) return Double.NaN;
        if (magnitude == 0 && 1 / x < 0 && origin != 0) return Double.NaN;
        return x < 0 || magnitude == 0 && 1 / x < 0 ? -magnitude : magnitude;
    }

    /** The offset of a number, as the float32 number that is coded. */
    float offset(int component, double x) {
        double units = units(component, x);
        double offset = units == units ? (units - origins[component]) / scale : x - origin(component);
        int bits = Float.floatToIntBits((float) offset);
        if ((bits & 0x7fffffff) > LARGEST_FLOAT) bits = bits & 0x80000000 | LARGEST_FLOAT;
        return Float.intBitsToFloat(bits);
    }

    /** The number of an offset as far as that tells. */
    double number(int component, float offset) {
        if (isBinary()) return origins[component] == 0 ? offset : finite(origins[component] + offset);
        return number(component, offset, nearest(offset));
    }

    /** The number that is so many units from the origin; the offset says which zero it is. */
    double number(int component, float offset, int units) {
        if (units == 0 && origins[component] == 0) return offset == 0 ? offset : 0;
        return (origins[component] + units) / scale;
    }

    /** The units that an offset is closest to. */
    int nearest(float offset) {
        double units = Math.abs((double) offset) * scale + .5;
        int whole = units < Integer.MAX_VALUE ? (int) units : Integer.MAX_VALUE;
        return offset < 0 ? -whole : whole;
    }

    /** By how many units the rounding to an offset may have hidden a number. */
    int spread(float offset) {
        double units = halfStep(offset) * scale;
        return units < .25 ? 0 : (int) Math.min(units + .75, MOST_UNITS / 2);
    }

    /** Half the distance between float32 numbers of this size. */
    static double halfStep(float offset) {
        int exponent = Float.floatToRawIntBits(offset) >>> 23 & 255;
        double step = exponent > 23 ? Float.intBitsToFloat(exponent - 23 << 23) : Float.MIN_VALUE;
        if (exponent > 0 && exponent <= 23) step = Float.intBitsToFloat(1 << exponent - 1);
        return step / 2;
    }

    static double finite(double x) {
        return Math.max(-Double.MAX_VALUE, Math.min(Double.MAX_VALUE, x));
    }

    /** Codes a form in either direction. */
    static ExactForm code(BinaryCoder coder, IntegerModel model, ExactForm form, int components)
            throws MalformedStreamException {
        boolean write = coder.isEncoder();
        int places = model.unsigned(coder, write ? form.places + 1 : 0) - 1;
        if (places > MOST_PLACES) throw new MalformedStreamException(-1, "numbers of " + places + " decimals");
        boolean exceptions = coder.raw(write && form.hasExceptions ? 1 : 0, 1) != 0;
        boolean whole = coder.raw(write && form.isWhole ? 1 : 0, 1) != 0;
        int zeros = places == BINARY || exceptions ? coder.raw(write ? form.zeros : 0, 6) : 0;
        if (zeros > MOST_ZEROS) throw new MalformedStreamException(-1, "numbers with " + zeros + " zero bits");
        double[] origins = new double[components];
        for (int c = 0; c < components; c++)
            origins[c] = codeOrigin(coder, model, write ? form.origins[c] : 0, places == BINARY);
        return new ExactForm(places, origins, exceptions, zeros, whole);
    }

    private static double codeOrigin(BinaryCoder coder, IntegerModel model, double origin, boolean isBinary)
            throws MalformedStreamException {
        if (coder.raw(origin != 0 ? 1 : 0, 1) == 0) return 0;
        if (isBinary) {
            long bits = Double.doubleToRawLongBits(origin);
            long low = coder.raw((int) bits, 32) & 0xffffffffL;
            double number = Double.longBitsToDouble((long) coder.raw((int) (bits >>> 32), 32) << 32 | low);
            if (Math.abs(number) <= Double.MAX_VALUE) return number;
            throw new MalformedStreamException(-1, "an origin is not finite");
        }
        int sign = coder.raw(origin < 0 ? 1 : 0, 1);
        long units = (long) Math.abs(origin);
        long high = model.unsigned(coder, (int) (units >>> 31));
        long whole = high << 31 | model.unsigned(coder, (int) units & Integer.MAX_VALUE);
        if (whole > MOST_WHOLE) throw new MalformedStreamException(-1, "an origin is too far away");
        return sign != 0 ? -(double) whole : whole;
    }
}
