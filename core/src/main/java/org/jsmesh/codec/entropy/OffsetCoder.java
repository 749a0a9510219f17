package org.jsmesh.codec.entropy;

import java.util.Arrays;

/**
 * Codes the place of a value in a known interval. It halves the interval again and again; the context of a half is how
 * far the prediction lies to either side of the middle. It counts what the predictions save, so that halves which they
 * do not predict can stay raw.
 */
public final class OffsetCoder {
    private static final int BITS = 29;
    private static final int PLACES = 16;
    private static final int AGREEING = 4;
    private final int[] halves;
    private final int[] same = BinaryCoder.newContexts(AGREEING);

    /** Cost of a bit by its probability in 256ths, itself in 256ths of a bit. */
    private static final int[] COST = new int[256];

    private final int[] saved; // by role and bit, in 256ths of a bit
    private final int[] rawBits; // by role: number of low bits that are not predicted
    private int savedBySame;

    static {
        for (int i = 0; i < 256; i++) COST[i] = 256 * 8 - IntegerLog.log256(2 * i + 1) + 256;
    }

    /** @param roles kinds of numbers with statistics of their own */
    public OffsetCoder(int roles) {
        halves = BinaryCoder.newContexts(roles * BITS * PLACES);
        saved = new int[roles * BITS];
        rawBits = new int[roles];
    }

    /** Predicts all bits from now on, and counts what that saves. */
    public void startCounting() {
        Arrays.fill(saved, 0);
        Arrays.fill(rawBits, 0);
        savedBySame = 0;
    }

    /**
     * Stops predicting the low bits whose prediction has saved nothing since counting started. Returns what this would
     * have saved compared with raw bits alone.
     */
    public int settle() {
        int all = savedBySame;
        for (int role = 0; role < rawBits.length; role++) {
            int best = 0;
            int sum = 0;
            rawBits[role] = BITS;
            for (int k = BITS - 1; k >= 0; k--) {
                sum += saved[role * BITS + k];
                if (sum > best) {
                    best = sum;
                    rawBits[role] = k;
                }
            }
            all += best;
        }
        return all >> 8;
    }

    /**
     * Codes whether the value is that of neighbours in the same interval; {@code agreeing} of these have the same one.
     */
    public boolean codeSame(BinaryCoder coder, int agreeing, boolean is) {
        int context = Math.min(agreeing, AGREEING) - 1;
        int before = same[context];
        int bit = coder.bit(same, context, is ? 1 : 0);
        savedBySame -= cost(before, bit);
        return bit != 0;
    }

    /** Counts the bits that are saved because the value was the same. */
    public void countSame(int bits) {
        savedBySame += bits << 8;
    }

    /**
     * @param predicted where the offset is expected, perhaps outside of the interval
     * @param bits the offset has: it is 0 .. 2^bits − 1
     */
    public int code(BinaryCoder coder, int role, int predicted, int bits, int offset) {
        int low = 0;
        int left = Math.min(rawBits[role], bits);
        for (int k = bits - 1; k >= left; k--) {
            int distance = predicted - low - (1 << k);
            int place = distance < 0
                    ? Math.max(-PLACES / 2, (distance + 1 << 2 >> k) - 1)
                    : Math.min(PLACES / 2 - 1, distance << 2 >> k);
            int context = (role * BITS + k) * PLACES + place + PLACES / 2;
            int before = halves[context];
            int bit = coder.bit(halves, context, offset >> k & 1);
            saved[role * BITS + k] += 256 - cost(before, bit);
            if (bit != 0) low += 1 << k;
        }
        return left == 0 ? low : low + coder.raw(offset & (1 << left) - 1, left);
    }

    private static int cost(int context, int bit) {
        int ones = context >>> 16;
        return COST[bit != 0 ? ones : 255 - ones];
    }
}
