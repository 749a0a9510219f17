package org.jsmesh.codec.lattice;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Finds the lattice on which a column of float32 values is cheapest to code. It compares all numbers of decimal digits
 * and float32 itself by the bits that the values' own resolution costs, with a price for values off the lattice.
 */
public final class LatticeDetector {
    private static final double BITS_PER_DIGIT = 3.321928094887362;
    private static final int EXCEPTION_BITS = 8;

    /** The biased exponent of float32 numbers whose last bit is 1. */
    private static final int BINARY_EXPONENT = 150;

    private static final RadixPowers[] TRIED = {RadixPowers.TEN, RadixPowers.ROUNDED_TEN, RadixPowers.TWO};

    private static final int EXPONENTS = Lattice.MAX_EXPONENT - Lattice.MIN_EXPONENT + 1;
    private static final double TOLERATED = .15;

    /**
     * Most cells from 0 to a value. Only exceptions are further away than the lattice's points, and boxes do not hold
     * what is further away than this.
     */
    private static final double MOST_CELLS = 1 << 27;

    /** Values by which lattices are compared. */
    private static final int SAMPLE = 1 << 13;

    private LatticeDetector() {}

    /** What the values cost on their lattice, up to a constant per value; for comparison. */
    public static double bits(int[] values) {
        return best(values).bits;
    }

    /** @param values raw float32 bits; absent ones are 0 and cost nothing */
    public static Lattice detect(int[] values) {
        return best(values).lattice();
    }

    /**
     * The same for positions: none of them is so far out that a box around them has no place on the lattice.
     *
     * @param values raw float32 bits
     */
    public static Lattice detectAround(int[] values) {
        return best(values, MOST_CELLS).lattice();
    }

    private static Trial best(int[] values) {
        return best(values, Double.POSITIVE_INFINITY);
    }

    /** Returns the first lattice that suits all values, trying those that suit a sample, the best first. */
    private static Trial best(int[] values, double mostCells) {
        int[] sample = sample(values);
        List<Trial> suited = new ArrayList<>();
        for (RadixPowers powers : TRIED) {
            boolean binary = powers == RadixPowers.TWO;
            int most = binary ? Lattice.BINARY_DIGITS : Lattice.MAX_DECIMAL_DIGITS;
            for (int digits = binary ? most : 2; digits <= most; digits++) {
                Trial trial = new Trial(powers, digits);
                if (trial.run(sample)) suited.add(trial);
            }
        }
        suited.sort(Comparator.comparingDouble(t -> t.bits)); // float32 itself suits everything
        int i = 0;
        while (true) {
            Trial trial = new Trial(suited.get(i).powers, suited.get(i).digits);
            if (trial.run(values) && trial.cells() <= mostCells) return trial;
            i++;
        }
    }

    private static int[] sample(int[] values) {
        if (values.length <= 2 * SAMPLE) return values;
        int[] sample = new int[SAMPLE];
        for (int i = 0; i < SAMPLE; i++) sample[i] = values[(int) ((long) i * values.length / SAMPLE)];
        return sample;
    }

    private static final class Trial {
        final RadixPowers powers;
        final int digits;
        final LatticePoint point = new LatticePoint();
        int minExponent = Integer.MAX_VALUE;
        int maxExponent = Integer.MIN_VALUE;
        int exceptions;
        int exceptionBits;
        double furthest; // exception
        double bits;

        Trial(RadixPowers powers, int digits) {
            this.powers = powers;
            this.digits = digits;
        }

        boolean run(int[] values) {
            int tolerated = (int) (values.length * TOLERATED);
            int[] points = new int[EXPONENTS]; // by exponent
            for (int value : values) {
                if ((value & 0x7fffffff) == 0) continue;
                if (!point.find(powers, digits, Lattice.MIN_EXPONENT, value)) {
                    if (++exceptions > tolerated) return false;
                    furthest = Math.max(furthest, Math.abs(Float.intBitsToFloat(value)));
                    exceptionBits += EXCEPTION_BITS + BINARY_EXPONENT - (value >>> 23 & 255);
                    continue;
                }
                int stripped = point.strippedExponent(powers.radix);
                if (stripped < minExponent) minExponent = stripped;
                if (point.exponent > maxExponent) maxExponent = point.exponent;
                points[point.exponent - Lattice.MIN_EXPONENT]++;
            }
            if (minExponent == Integer.MAX_VALUE) { // zeros alone
                minExponent = 0;
                maxExponent = 0;
            }
            if (minExponent > maxExponent) maxExponent = Math.max(maxExponent, Math.min(minExponent, 30));
            double exponents = 0;
            for (int i = 0; i < EXPONENTS; i++)
                exponents += (double) points[i] * Math.max(i + Lattice.MIN_EXPONENT, minExponent);
            bits = exceptionBits - exponents * (powers.radix == 10 ? BITS_PER_DIGIT : 1);
            return true;
        }

        /** Cells from 0 to the furthest exception. */
        double cells() {
            return furthest / lattice().spacing();
        }

        Lattice lattice() {
            int grid = Math.max(minExponent, maxExponent);
            return new Lattice(powers, digits, Math.min(minExponent, grid), grid, exceptions > 0);
        }
    }
}
