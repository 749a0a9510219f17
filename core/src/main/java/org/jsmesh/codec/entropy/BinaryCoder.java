package org.jsmesh.codec.entropy;

/**
 * Codes decisions under adaptive probabilities, in one direction. An encoder writes the values it is given and returns
 * them. A decoder ignores its arguments and returns what it reads. So one model serves both sides, and they cannot
 * disagree.
 *
 * <p>A context is an int made by {@link #newContexts}: the probability of a one is in the upper 16 of 24 bits, the
 * number of observations below.
 */
public abstract class BinaryCoder {
    static final int PROBABILITY_BITS = 15;
    private static final int COUNT_LIMIT = 62;
    private static final int LEAST = 48; // in 65536ths; no probability comes below it, nor closer to 1
    private static final int[] RATE = new int[COUNT_LIMIT + 1];

    static {
        for (int n = 0; n <= COUNT_LIMIT; n++) RATE[n] = (int) (65536 / (n + 1.6)) >> 1;
    }

    /** Fresh contexts: both values equally probable. */
    public static int[] newContexts(int count) {
        int[] contexts = new int[count];
        java.util.Arrays.fill(contexts, 0x8000 << 8);
        return contexts;
    }

    /**
     * A context that starts with a probability.
     *
     * @param probability of a one, in 65536ths
     * @param count of observations that it is worth, up to {@value #COUNT_LIMIT}
     */
    public static int context(int probability, int count) {
        return Math.max(LEAST, Math.min(65535 - LEAST, probability)) << 8 | count;
    }

    /** True for the side that writes. */
    public abstract boolean isEncoder();

    /** True when a decoder has read more than its bytes hold. */
    public boolean isExhausted() {
        return false;
    }

    /** Codes one bit under a probability of a one, 1 .. 32767 of 32768. */
    abstract int codeBit(int probability, int bit);

    /** Codes {@code count} (0 to 16) equally probable bits. */
    abstract int codeRaw(int value, int count);

    /** Codes a value of 0 .. bound − 1, all equally probable; bound up to 2^16. */
    abstract int codeBelow(int value, int bound);

    /** Codes a bit under one context. */
    public final int bit(int[] contexts, int index, int bit) {
        int state = contexts[index];
        int coded = codeBit(state >>> 9, bit);
        contexts[index] = adapt(state, coded);
        return coded;
    }

    /** Codes a bit under the mean of two contexts' probabilities. */
    public final int bit(int[] first, int i, int[] second, int j, int bit) {
        int a = first[i];
        int b = second[j];
        int coded = codeBit((a >>> 9) + (b >>> 9) >> 1, bit);
        first[i] = adapt(a, coded);
        second[j] = adapt(b, coded);
        return coded;
    }

    static int adapt(int state, int bit) {
        int count = state & 255;
        int probability = state >>> 8;
        int step = (LEAST + bit * (65535 - 2 * LEAST) - probability) * RATE[count] >> 15;
        return probability + step << 8 | (count < COUNT_LIMIT ? count + 1 : count);
    }

    /** Codes {@code count} (0 to 32) equally probable bits. */
    public final int raw(int value, int count) {
        if (count <= 16) return codeRaw(value, count);
        int high = codeRaw(value >>> 16, count - 16);
        return high << 16 | codeRaw(value & 0xffff, 16);
    }

    /** Codes a value of 0 .. bound − 1, all equally probable; any positive bound. */
    public final int uniform(int value, int bound) {
        if (bound <= 0x10000) return codeBelow(value, bound);
        int high = codeBelow(value >>> 15, (bound - 1 >>> 15) + 1);
        int whole = high << 15 | codeRaw(value & 0x7fff, 15);
        return Math.min(whole, bound - 1); // larger only in damaged streams
    }
}
