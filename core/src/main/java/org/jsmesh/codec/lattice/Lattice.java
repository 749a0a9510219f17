package org.jsmesh.codec.lattice;

import org.jsmesh.codec.entropy.IntegerLog;

/**
 * The set of numbers that a column of float32 values belongs to: numbers m · radix^e with at most {@code digits} digits
 * in m and e ≥ {@code minExponent}, rounded to float32. Most published models were once decimal text and lie on a
 * decimal lattice; radix 2 with 24 digits is float32 itself.
 *
 * <p>A value is coded as its <em>cell</em> of a uniform grid with spacing radix^{@code gridExponent}, the spacing of
 * the largest values, and its place among the lattice's points in that cell: one point in the outermost decade, ten in
 * the next. Cells are symmetric: q ≥ 0 for +, −1 − q for −, so that −0 has a place.
 */
public final class Lattice {
    public static final int MAX_DECIMAL_DIGITS = 8;
    public static final int BINARY_DIGITS = 24;
    public static final int MIN_EXPONENT = -149;
    public static final int MAX_EXPONENT = 127;
    private static final int[] INT_TENS = {
        1, 10, 100, 1000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000, 1_000_000_000
    };

    public final RadixPowers powers;
    public final int digits;
    public final int minExponent;
    public final int gridExponent;
    /** False when every value is on the lattice. */
    public final boolean hasExceptions;

    public Lattice(RadixPowers powers, int digits, int minExponent, int gridExponent, boolean hasExceptions) {
        this.powers = powers;
        this.digits = digits;
        this.minExponent = minExponent;
        this.gridExponent = gridExponent;
        this.hasExceptions = hasExceptions;
    }

    /** radix^exponent for an exponent of 0 or more that fits an int. */
    int power(int exponent) {
        return powers == RadixPowers.TWO ? 1 << exponent : INT_TENS[exponent];
    }

    /** Cells are smaller than this in magnitude. */
    public int cellLimit() {
        return power(digits);
    }

    /** The float32 closest to the lower edge of a cell, for showing; finite. */
    public int shownBits(int cell) {
        int bits = Math.min(powers.bits(cell < 0 ? -cell : cell, gridExponent), 0x7f7fffff);
        return cell < 0 ? bits | 0x80000000 : bits;
    }

    /** The grid's spacing. */
    public double spacing() {
        return powers.number(1, gridExponent);
    }

    /** The float32 bits of a point of the lattice that is next to a number. */
    public int closest(double number) {
        double x = Math.abs(number);
        double cells = x / spacing();
        int limit = cellLimit() - 1;
        int cell = cells >= limit ? limit : (int) cells;
        int exponent = cell > 0 ? exponentIn(cell) : Math.max(minExponent, gridExponent - digits);
        if (cell == limit) x = Math.min(x, powers.number(limit, gridExponent));
        double mantissa = powers.scaled(x, exponent);
        if (cell == 0) {
            double full = power(digits - 1);
            while (exponent > minExponent && mantissa < full) mantissa = powers.scaled(x, --exponent);
        }
        int bits = Math.min(powers.bits((int) (mantissa + .5), exponent), 0x7f7fffff);
        return number < 0 ? bits | 0x80000000 : bits;
    }

    /**
     * The number of a point among the non-negative ones, smallest first; whole, and beyond int where the lattice spans
     * many decades.
     */
    double index(int mantissa, int exponent) {
        double step = cellLimit() - power(digits - 1);
        return (exponent - minExponent) * step + mantissa;
    }

    /** The float32 bits of the point with an {@link #index} that is not negative. */
    int bitsAt(double index) {
        int limit = cellLimit();
        double step = limit - power(digits - 1);
        int up = index < limit ? 0 : 1 + (int) ((index - limit) / step);
        return powers.bits((int) (index - up * step), minExponent + up);
    }

    /** The cell of a value that is not on the lattice. */
    int nearestCell(int floatBits) {
        double x = Float.intBitsToFloat(floatBits & 0x7fffffff);
        double q = x / spacing();
        int limit = cellLimit() - 1;
        int cell = q >= limit ? limit : (int) q;
        return floatBits < 0 ? -1 - cell : cell;
    }

    /** Exponent of the lattice's points in the cells of magnitude {@code q} > 0. */
    int exponentIn(int q) {
        int natural = IntegerLog.bits(q);
        if (powers != RadixPowers.TWO) {
            natural = natural * 1233 >> 12; // log10(2) = 1233/4096: the number of digits, or one less
            if (q >= INT_TENS[natural]) natural++;
        }
        return Math.max(Math.min(gridExponent, gridExponent + natural - digits), minExponent);
    }

    @Override
    public String toString() {
        return "Lattice(" + powers + ", " + digits + " digits, from " + minExponent + " .. " + gridExponent
                + (hasExceptions ? ", exceptions)" : ")");
    }
}
