package org.jsmesh.codec.entropy;

/**
 * Codes the place of a value in a known interval, given where it is expected and about how far from there. It halves
 * the interval again and again until both halves are about equally probable. The probability of a half comes from
 * Student's distribution with two degrees of freedom, and adapts to how halves of that probability turned out before.
 * So there is little to learn, which saves bytes in short streams.
 */
public final class SpreadCoder {
    private static final int ODDS = 49; // half octaves, the middle one even
    private static final int TRUST = 6; // observations that the distribution stands for
    private static final int ONE = 1 << 14;
    private final int[] halves;

    /** @param roles kinds of numbers with statistics of their own */
    public SpreadCoder(int roles) {
        halves = new int[roles * ODDS];
        for (int i = 0; i < halves.length; i++) {
            double odds = 1;
            int steps = i % ODDS - ODDS / 2;
            for (int n = steps < 0 ? -steps : steps; n > 0; n--) odds *= 1.4142135623730951;
            double p = odds / (1 + odds);
            halves[i] = (int) (65535 * (steps < 0 ? 1 - p : p)) << 8 | TRUST;
        }
    }

    /**
     * @param predicted where the value is expected, perhaps outside of the interval
     * @param size expected distance from there
     * @param bits the offset has: it is 0 .. 2^bits − 1
     */
    public int code(BinaryCoder coder, int role, double predicted, double size, int bits, int offset) {
        int low = 0;
        double square = size * size * 2;
        double below = share(-predicted, square);
        double above = share((1 << bits) - predicted, square);
        for (int k = bits - 1; k >= 0; k--) {
            if (4 << k <= size) return low + coder.raw(offset & (2 << k) - 1, k + 1);
            int middle = low + (1 << k);
            double at = share(middle - predicted, square);
            double all = above - below;
            int ones = all > 0 ? (int) ((above - at) / all * ONE) : ONE / 2;
            ones = Math.max(0, Math.min(ONE, ones));
            int odds = IntegerLog.log8(1 + ones) - IntegerLog.log8(1 + ONE - ones);
            int step = Math.max(-ODDS / 2, Math.min(ODDS / 2, odds + 2 >> 2));
            if (coder.bit(halves, role * ODDS + step + ODDS / 2, offset >> k & 1) != 0) {
                low = middle;
                below = at;
            } else {
                above = at;
            }
        }
        return low;
    }

    /** Twice the share of values below a distance, less 1. */
    private static double share(double distance, double square) {
        return distance / Math.sqrt(square + distance * distance);
    }
}
