package org.jsmesh.codec;

/**
 * Finds the lattice on which a column of float32 values is cheapest to code: for every number of decimal digits, and for float32 itself, the bits
 * that the values' own resolution costs, with a price for values off the lattice.
 */
final class LatticeDetector {
    private static final double BITS_PER_DIGIT = 3.321928094887362;
    private static final int EXCEPTION_BITS = 8;

    /** The biased exponent of float32 numbers whose last bit is 1. */
    private static final int BINARY_EXPONENT = 150;

    private static final Powers[] TRIED = {Powers.TEN, Powers.ROUNDED_TEN, Powers.TWO};

    private static final double TOLERATED = .15;

    private LatticeDetector() {}

    /** What the values cost on their lattice, up to a constant per value; for comparison. */
    static double bits(int[] values) {
        return best(values).bits;
    }

    /** @param values raw float32 bits; absent ones are 0 and cost nothing */
    static Lattice detect(int[] values) {
        return best(values).lattice();
    }

    private static Trial best(int[] values) {
        Trial best = null;
        for (Powers powers : TRIED) {
            boolean binary = powers == Powers.TWO;
            int most = binary ? Lattice.BINARY_DIGITS : Lattice.MAX_DECIMAL_DIGITS;
            for (int digits = binary ? most : 2; digits <= most; digits++) {
                Trial trial = new Trial(powers, digits);
                if (trial.run(values) && (best == null || trial.bits < best.bits)) best = trial;
            }
        }
        return best;
    }

    private static final class Trial {
        final Powers powers;
        final int digits;
        final LatticePoint point = new LatticePoint();
        int minExponent = Integer.MAX_VALUE;
        int maxExponent = Integer.MIN_VALUE;
        int exceptions;
        int exceptionBits;
        double bits;

        Trial(Powers powers, int digits) {
            this.powers = powers;
            this.digits = digits;
        }

        boolean run(int[] values) {
            int tolerated = (int) (values.length * TOLERATED);
            double exponents = 0;
            int points = 0;
            for (int value : values) {
                if ((value & 0x7fffffff) == 0) continue;
                if (!point.find(powers, digits, Lattice.MIN_EXPONENT, value)) {
                    if (++exceptions > tolerated) return false;
                    exceptionBits += EXCEPTION_BITS + BINARY_EXPONENT - (value >>> 23 & 255);
                    continue;
                }
                int stripped = point.strippedExponent(powers.radix);
                if (stripped < minExponent) minExponent = stripped;
                if (point.exponent > maxExponent) maxExponent = point.exponent;
            }
            if (minExponent > maxExponent) maxExponent = Math.max(maxExponent, Math.min(minExponent, 30));
            for (int value : values) {
                if ((value & 0x7fffffff) == 0 || !point.find(powers, digits, Lattice.MIN_EXPONENT, value)) continue;
                exponents += Math.max(point.exponent, minExponent);
                points++;
            }
            if (points == 0) {
                minExponent = 0;
                maxExponent = 0;
            }
            bits = exceptionBits - exponents * (powers.radix == 10 ? BITS_PER_DIGIT : 1);
            return true;
        }

        Lattice lattice() {
            int grid = Math.max(minExponent, maxExponent);
            return new Lattice(powers, digits, Math.min(minExponent, grid), grid, exceptions > 0);
        }
    }
}
