package org.jsmesh.codec.entropy;

/** Logarithms in integers, the same on every machine. */
public final class IntegerLog {
    private static final int[] EIGHTHS = new int[64];

    static {
        for (int i = 0; i < 64; i++) {
            double x = 1 + (i + .5) / 64;
            int log16 = 0;
            for (int b = 0; b < 4; b++) { // binary digits of log2 by squaring
                x *= x;
                log16 <<= 1;
                if (x >= 2) {
                    log16 |= 1;
                    x /= 2;
                }
            }
            EIGHTHS[i] = log16 + 1 >> 1;
        }
    }

    private IntegerLog() {}

    /** 8 · log2(x), rounded, for x ≥ 1. */
    public static int log8(int x) {
        int zeros = Integer.numberOfLeadingZeros(x);
        return (31 - zeros << 3) + EIGHTHS[x << zeros >>> 25 & 63];
    }

    /** 256 · log2(x), rounded down, for x ≥ 1; by repeated squaring, for tables. */
    static int log256(int x) {
        int whole = bits(x) - 1;
        double rest = (double) x / (1 << whole);
        int log = whole;
        for (int b = 0; b < 8; b++) {
            rest *= rest;
            log <<= 1;
            if (rest >= 2) {
                log |= 1;
                rest /= 2;
            }
        }
        return log;
    }

    /** Bits of a non-negative number. */
    public static int bits(int x) {
        return 32 - Integer.numberOfLeadingZeros(x);
    }
}
