package org.jsmesh.codec;

/** Logarithms in integers, the same on every machine. */
final class IntegerLog {
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
    static int log8(int x) {
        int zeros = Integer.numberOfLeadingZeros(x);
        return (31 - zeros << 3) + EIGHTHS[x << zeros >>> 25 & 63];
    }

    /** Bits of a non-negative number. */
    static int bits(int x) {
        return 32 - Integer.numberOfLeadingZeros(x);
    }
}
