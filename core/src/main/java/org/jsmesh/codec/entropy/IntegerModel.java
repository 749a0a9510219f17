package org.jsmesh.codec.entropy;

/**
 * Adaptive Exp-Golomb code of non-negative and signed integers. The bit length is in unary under adaptive contexts, the
 * highest bits below the leading one are adaptive too, the rest is raw. One instance per kind of number.
 */
public final class IntegerModel {
    private static final int LENGTHS = 32;
    private final int[] length;
    private final int[] mantissa = BinaryCoder.newContexts(4 * (LENGTHS + 1));
    private final int[] sign = BinaryCoder.newContexts(1);

    /** @param classes number of separate statistics for the bit length */
    public IntegerModel(int classes) {
        length = BinaryCoder.newContexts(classes * LENGTHS);
    }

    /** Codes a value of 0 .. 2^31 − 1. */
    public int unsigned(BinaryCoder coder, int value) {
        return unsigned(coder, 0, value);
    }

    /** Codes a value of 0 .. 2^31 − 1. */
    public int unsigned(BinaryCoder coder, int statistics, int value) {
        int bits = coder.isEncoder() ? 32 - Integer.numberOfLeadingZeros(value) : 0;
        int n = 0;
        while (n < LENGTHS - 1 && coder.bit(length, statistics * LENGTHS + n, bits > n ? 1 : 0) != 0) n++;
        if (n < 2) return n;
        int result = 1;
        int left = n - 1;
        for (int i = 0; i < 2 && left > 0; i++) {
            left--;
            int context = 4 * n + (i == 0 ? 0 : 1 + (result & 1));
            result = result << 1 | coder.bit(mantissa, context, value >>> left & 1);
        }
        return left == 0 ? result : result << left | coder.raw(value & (1 << left) - 1, left);
    }

    /** Codes a value of −(2^31 − 1) .. 2^31 − 1. */
    public int signed(BinaryCoder coder, int statistics, int value) {
        int magnitude = unsigned(coder, statistics, value < 0 ? -value : value);
        if (magnitude == 0) return 0;
        return coder.bit(sign, 0, value < 0 ? 1 : 0) != 0 ? -magnitude : magnitude;
    }
}
