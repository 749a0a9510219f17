package org.jsmesh.mesh.io;

import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;

/**
 * Reads decimal numbers from bytes, correctly rounded (the result of {@link Float#parseFloat} or
 * {@link Double#parseDouble}), without a string for nearly all of them. It takes Clinger's fast path (How to Read
 * Floating Point Numbers Accurately, 1990), and for float32 also an interval that rounds to one float.
 */
final class Decimal {
    private static final int MAX_DIGITS = 18;
    private static final int MAX_POWER = 22;
    private static final long EXACT = 1L << 53;
    private static final long FEW = 1_000_000; // float32 holds all numbers of six digits
    private static final long MANY = 1_000_000_000_000_000L; // units of more digits are not exact in float64
    private static final double[] POWERS = new double[MAX_POWER + 1];

    static {
        double power = 1;
        for (int i = 0; i <= MAX_POWER; i++, power *= 10) POWERS[i] = power;
    }

    private byte[] bytes;
    private int from;
    private int to;
    private boolean negative;
    private long digits;
    private boolean truncated;
    private long exponent;

    /** Takes {@code [+-]digits[.digits][e[+-]digits]}; false when the bytes are anything else. */
    boolean scan(byte[] source, int start, int end) {
        bytes = source;
        from = start;
        to = end;
        int at = start;
        negative = at < end && source[at] == '-';
        if (at < end && (source[at] == '-' || source[at] == '+')) at++;
        digits = 0;
        truncated = false;
        exponent = 0;
        int taken = 0;
        boolean any = false;
        boolean fraction = false;
        for (; at < end; at++) {
            int c = source[at];
            if (c == '.' && !fraction) {
                fraction = true;
                continue;
            }
            if (c < '0' || c > '9') break;
            any = true;
            if (taken < MAX_DIGITS) {
                digits = 10 * digits + (c - '0');
                if (digits != 0) taken++;
                if (fraction) exponent--;
            } else {
                truncated |= c != '0';
                if (!fraction) exponent++;
            }
        }
        if (!any) return false;
        return at == end || scanExponent(at);
    }

    private boolean scanExponent(int start) {
        int at = start;
        if (bytes[at] != 'e' && bytes[at] != 'E') return false;
        at++;
        boolean down = at < to && bytes[at] == '-';
        if (at < to && (bytes[at] == '-' || bytes[at] == '+')) at++;
        if (at == to) return false;
        long power = 0;
        for (; at < to; at++) {
            int c = bytes[at];
            if (c < '0' || c > '9') return false;
            if (power < 1_000_000_000_000L) power = 10 * power + (c - '0');
        }
        exponent += down ? -power : power;
        return true;
    }

    /** The number as float32; infinite when it is too large. */
    float toFloat() {
        if (digits == 0) return negative ? -0f : 0f;
        if (exponent < -2 * MAX_POWER || exponent > 2 * MAX_POWER) return Float.parseFloat(text());
        double d = scaled();
        if (d < Float.MIN_NORMAL) return Float.parseFloat(text());
        // (double) digits, two powers and the cut digits are off by less than 1e-15 together
        float low = (float) (d - d * 1e-15);
        float high = (float) (d + d * 1e-15);
        if (low != high) return Float.parseFloat(text());
        return negative ? -low : low;
    }

    /** The number as float64; infinite when it is too large. */
    double toDouble() {
        if (digits == 0) return negative ? -0d : 0d;
        if (truncated || digits > EXACT || exponent < -MAX_POWER || exponent > MAX_POWER)
            return Double.parseDouble(text());
        double d = scaled();
        return negative ? -d : d;
    }

    /**
     * Does float32 hold the number as it is written? It does when the closest float32, written with as many digits, is
     * the same text, or when it is the very number to the precision of float64. So it is with what programs write that
     * compute in float32.
     */
    boolean isHeldByFloat() {
        if (digits == 0) return true;
        float closest = toFloat();
        double written = Math.abs((double) closest);
        if (digits < FEW && !truncated && written >= Float.MIN_NORMAL) return true;
        double number = toDouble();
        if (closest == number) return true;
        if ((float) number != closest || truncated || digits >= MANY) return false;
        if (Math.abs(exponent) > 2 * MAX_POWER) return isWrittenAs(closest);
        int power = (int) Math.abs(exponent);
        int first = Math.min(power, MAX_POWER);
        double units = exponent < 0
                ? written * POWERS[first] * POWERS[power - first]
                : written / POWERS[first] / POWERS[power - first];
        return Math.abs(units - digits) <= .5 * (1 + 1e-6);
    }

    /** The same for numbers that are beyond the powers here. */
    private boolean isWrittenAs(float closest) {
        if (closest == 0 || Math.abs(exponent) > 99) return false;
        BigDecimal unit = BigDecimal.ONE.scaleByPowerOfTen((int) exponent);
        BigDecimal written = new BigDecimal(Math.abs((double) closest));
        BigDecimal off = written.subtract(unit.multiply(BigDecimal.valueOf(digits)));
        return off.abs().multiply(BigDecimal.valueOf(2)).compareTo(unit) <= 0;
    }

    /** True when the text has neither a point nor an exponent, so that it is meant as an integer. */
    boolean isInteger() {
        for (int i = from; i < to; i++) {
            if (bytes[i] == '.' || bytes[i] == 'e' || bytes[i] == 'E') return false;
        }
        return true;
    }

    private double scaled() {
        double d = digits;
        int power = (int) Math.abs(exponent);
        int first = Math.min(power, MAX_POWER);
        return exponent < 0 ? d / POWERS[first] / POWERS[power - first] : d * POWERS[first] * POWERS[power - first];
    }

    private String text() {
        return new String(bytes, from, to - from, StandardCharsets.ISO_8859_1);
    }
}
