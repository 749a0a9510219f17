package org.jsmesh.codec;

/**
 * Codes the difference between a value and its prediction. The bit length is coded in unary steps up or down from a running mean that each (role,
 * scale) pair keeps; sign and highest bit adapt; the rest is raw.
 */
final class ResidualCoder {
    /** Scales: eighths of a binary order, halved, of the expected size. */
    static final int SCALES = 128;

    private static final int LENGTHS = 32;
    private final int[] mean; // 256 × bit length
    private final int[] up;
    private final int[] down;
    private final int[] top;
    private final int[] sign;

    ResidualCoder(int roles) {
        int classes = roles * SCALES;
        mean = new int[classes];
        for (int i = 0; i < classes; i++) mean[i] = (i % SCALES) * 64;
        up = BinaryCoder.newContexts(classes * LENGTHS);
        down = BinaryCoder.newContexts(classes * LENGTHS);
        top = BinaryCoder.newContexts(classes * LENGTHS);
        sign = BinaryCoder.newContexts(roles * LENGTHS * 3);
    }

    /** The scale class of an expected size. */
    static int scale(int size) {
        return Math.min(SCALES - 1, IntegerLog.log8(Math.max(1, size)) >> 1);
    }

    /**
     * @param role kind of number, 0 .. roles − 1
     * @param scale class of the expected size, see {@link #scale}
     * @param lean −1, 0 or 1: where the value is likely to lie
     */
    int code(BinaryCoder coder, int role, int scale, int lean, int residual) {
        int context = role * SCALES + scale;
        int at = context * LENGTHS;
        int magnitude = residual < 0 ? -residual : residual;
        int bits = coder.isEncoder() ? IntegerLog.bits(magnitude) : 0;
        int n = mean[context] + 128 >> 8;
        if (coder.bit(up, at + n, bits > n ? 1 : 0) != 0) {
            n++;
            while (n < LENGTHS - 1 && coder.bit(up, at + n, bits > n ? 1 : 0) != 0) n++;
        } else {
            while (n > 0 && coder.bit(down, at + n, bits < n ? 1 : 0) != 0) n--;
        }
        mean[context] += ((n << 8) - mean[context]) >> 4;
        if (n == 0) return 0;
        boolean negative = coder.bit(sign, (role * LENGTHS + n) * 3 + lean + 1, residual < 0 ? 1 : 0) != 0;
        int value = 1;
        int left = n - 1;
        if (left > 0) {
            left--;
            value = 2 | coder.bit(top, at + n, magnitude >>> left & 1);
            if (left > 0) value = value << left | coder.raw(magnitude & (1 << left) - 1, left);
        }
        return negative ? -value : value;
    }
}
