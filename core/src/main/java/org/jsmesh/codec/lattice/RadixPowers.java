package org.jsmesh.codec.lattice;

/** The powers that mantissas are multiplied by. Numbers of a lattice are m · radix^e, rounded to float32. */
public enum RadixPowers {
    TWO(2),
    TEN(10),
    /**
     * Negative powers of ten are float32 numbers themselves, and trailing zeros of mantissas do not count. Programs
     * that have float32 arithmetic alone read decimals in this way.
     */
    ROUNDED_TEN(10);

    private static final int COUNT = 150;
    final int radix;
    private final double[] positive =
            new double[COUNT]; // products in doubles: not always the nearest, but the same everywhere
    private final double[] negative = new double[COUNT]; // of ROUNDED_TEN alone

    RadixPowers(int radix) {
        this.radix = radix;
        positive[0] = 1;
        for (int i = 1; i < COUNT; i++) positive[i] = positive[i - 1] * radix;
        for (int i = 0; i < COUNT; i++) negative[i] = rounded(1 / positive[i]);
    }

    /** Through bits: in JavaScript, floats are doubles. */
    private static double rounded(double x) {
        return Float.intBitsToFloat(Float.floatToIntBits((float) x));
    }

    /** m · radix^e; a product, or for e < 0 a quotient, unless powers are rounded. */
    public double number(int m, int e) {
        if (e >= 0) return m * positive[e];
        return this == ROUNDED_TEN ? product(m, e) : m / positive[-e];
    }

    private double product(int m, int e) {
        int digits = m;
        int power = e;
        while (power < 0 && digits % 10 == 0 && digits != 0) {
            digits /= 10;
            power++;
        }
        return digits * negative[-power];
    }

    /** The float32 bits of m · radix^e, m ≥ 0. */
    public int bits(int m, int e) {
        return Float.floatToIntBits((float) number(m, e));
    }

    /** x / radix^e. */
    double scaled(double x, int e) {
        return e < 0 ? x * positive[-e] : x / positive[e];
    }
}
