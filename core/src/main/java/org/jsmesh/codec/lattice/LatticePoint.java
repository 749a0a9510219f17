package org.jsmesh.codec.lattice;

/** Finds m and e of m · radix^e for a float32: the encoder's side of {@link Lattice}. One instance per thread. */
final class LatticePoint {
    private static final int LOWEST = -100;
    private static final int HIGHEST = 60;

    int mantissa;
    int exponent;
    private int known = -1; // digits for which the following hold
    private int limit;
    private final double[] ceilings = new double[HIGHEST - LOWEST + 1];
    private final double[] floors = new double[HIGHEST - LOWEST + 1];

    /**
     * Decomposes the magnitude of a value with at most {@code digits} digits and an exponent of at least
     * {@code minExponent}. False when the value is not such a number. Zero has mantissa 0.
     */
    boolean find(RadixPowers powers, int digits, int minExponent, int floatBits) {
        int bits = floatBits & 0x7fffffff;
        if (bits == 0) {
            mantissa = 0;
            exponent = minExponent;
            return true;
        }
        if (powers == RadixPowers.TWO) findBinary(bits, minExponent);
        else findDecimal(digits, minExponent, Float.intBitsToFloat(bits));
        return mantissa > 0 && powers.bits(mantissa, exponent) == bits;
    }

    private void findBinary(int bits, int minExponent) {
        int biased = bits >>> 23;
        mantissa = biased == 0 ? bits : bits & 0x7fffff | 0x800000;
        exponent = Math.max(biased, 1) - 150;
        if (exponent < minExponent) {
            int shift = minExponent - exponent;
            mantissa = shift > 30 || (mantissa & (1 << shift) - 1) != 0 ? 0 : mantissa >> shift;
            exponent = minExponent;
        }
    }

    private void findDecimal(int digits, int minExponent, double x) {
        if (digits != known) know(digits);
        exponent = -digits;
        while (exponent < HIGHEST && x >= ceilings[exponent - LOWEST]) exponent++;
        while (exponent > LOWEST && x < floors[exponent - LOWEST]) exponent--;
        if (exponent < minExponent) exponent = minExponent;
        double scaled =
                exponent < 0 ? RadixPowers.TEN.number(1, -exponent) * x : x / RadixPowers.TEN.number(1, exponent);
        mantissa = (int) (scaled + .5);
        if (mantissa >= limit) {
            mantissa /= 10;
            exponent++;
        }
    }

    /** Looks up once where the numbers of so many digits begin and end, for each exponent. */
    private void know(int digits) {
        known = digits;
        limit = 1;
        for (int i = 0; i < digits; i++) limit *= 10;
        for (int e = LOWEST; e < HIGHEST; e++) {
            ceilings[e - LOWEST] = RadixPowers.TEN.number(limit, e) * (1 - 1e-9);
            floors[e - LOWEST] = RadixPowers.TEN.number(limit / 10, e) * (1 - 1e-9);
        }
        floors[HIGHEST - LOWEST] = RadixPowers.TEN.number(limit / 10, HIGHEST) * (1 - 1e-9);
    }

    /** Drops trailing zeros: the exponent of the last nonzero digit. */
    int strippedExponent(int radix) {
        int m = mantissa;
        int e = exponent;
        while (m != 0 && m % radix == 0) {
            m /= radix;
            e++;
        }
        return e;
    }
}
