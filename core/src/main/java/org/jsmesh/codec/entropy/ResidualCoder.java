package org.jsmesh.codec.entropy;

/**
 * Codes the difference between a value and its prediction. Each pair of role and scale keeps a running mean of bit
 * lengths, and the bit length is coded in unary steps up or down from it. The contexts of a step are that pair, and how
 * well the neighbours were predicted; their mean counts. Sign and highest bit are adaptive; the rest is raw.
 */
public final class ResidualCoder {
    /** Scales: halves of a binary order of the expected size. */
    static final int SCALES = 64;

    /** Classes of how well neighbours were predicted; see {@link #surprise}. */
    static final int SURPRISES = 32;

    /** The class of an average neighbour. */
    public static final int NO_SURPRISE = SURPRISES / 2;

    /** Leans are −3 .. 3: to which side of the prediction the value is likely to lie, and how far. */
    static final int MOST_LEAN = 3;

    private static final int LEANS = 2 * MOST_LEAN + 1;
    private static final int LENGTHS = 32;
    private static final int DOWN = LENGTHS;
    private static final int COARSE = 8; // scales that share a context of surprise
    private final int[] mean; // 256 × bit length
    private final int[] byScale;
    private final int[] bySurprise;
    private final int[] top;
    private final int[] sign;
    private int lastLength;

    /** @param unit scale class of the size 1 */
    public ResidualCoder(int roles, int unit) {
        int classes = roles * SCALES;
        mean = new int[classes];
        for (int i = 0; i < classes; i++) mean[i] = Math.max(0, i % SCALES - unit) * 128;
        byScale = BinaryCoder.newContexts(classes * 2 * LENGTHS);
        bySurprise = BinaryCoder.newContexts(roles * (SCALES / COARSE) * SURPRISES * 2 * LENGTHS);
        top = BinaryCoder.newContexts(classes * LENGTHS);
        sign = BinaryCoder.newContexts(roles * LENGTHS * LEANS);
    }

    /** The scale class of an expected size. */
    public static int scale(int size) {
        return Math.min(SCALES - 1, IntegerLog.log8(Math.max(1, size)) >> 2);
    }

    /** Class of how much longer or shorter than its scale the last residual was. */
    public int surprise(int scale, int unit) {
        return Math.max(0, Math.min(SURPRISES - 1, 2 * lastLength - (scale - unit) + NO_SURPRISE));
    }

    /**
     * @param role kind of number, 0 .. roles − 1
     * @param scale class of the expected size, see {@link #scale}
     * @param surprise mean class of known neighbours
     * @param lean where the value is likely to lie
     */
    public int code(BinaryCoder coder, int role, int scale, int surprise, int lean, int residual) {
        int context = role * SCALES + scale;
        int at = context * 2 * LENGTHS;
        int also = ((role * (SCALES / COARSE) + scale / COARSE) * SURPRISES + surprise) * 2 * LENGTHS;
        int magnitude = residual < 0 ? -residual : residual;
        int bits = coder.isEncoder() ? IntegerLog.bits(magnitude) : 0;
        int middle = mean[context] + 128 >> 8;
        int n = middle;
        if (lengthBit(coder, at, also, n, middle, bits > n) != 0) {
            n++;
            while (n < LENGTHS - 1 && lengthBit(coder, at, also, n, middle, bits > n) != 0) n++;
        } else {
            while (n > 0 && lengthBit(coder, at + DOWN, also + DOWN, n, middle, bits < n) != 0) n--;
        }
        lastLength = n;
        mean[context] += ((n << 8) - mean[context]) >> 4;
        if (n == 0) return 0;
        boolean negative = coder.bit(sign, (role * LENGTHS + n) * LEANS + lean + MOST_LEAN, residual < 0 ? 1 : 0) != 0;
        int value = 1;
        int left = n - 1;
        if (left > 0) {
            left--;
            value = 2 | coder.bit(top, context * LENGTHS + n, magnitude >>> left & 1);
            if (left > 0) value = value << left | coder.raw(magnitude & (1 << left) - 1, left);
        }
        return negative ? -value : value;
    }

    /** One step of the bit length; the second context counts from the mean, so that it serves several scales. */
    private int lengthBit(BinaryCoder coder, int at, int also, int n, int middle, boolean is) {
        int relative = Math.max(0, Math.min(LENGTHS - 1, n - middle + LENGTHS / 2));
        return coder.bit(byScale, at + n, bySurprise, also + relative, is ? 1 : 0);
    }
}
