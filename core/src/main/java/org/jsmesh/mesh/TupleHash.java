package org.jsmesh.mesh;

/**
 * Hashes of tuples of ints of one length, for the reasons that {@link KeyHash} has. Two tuples share a hash with the
 * chance 2<sup>−32</sup>, whatever they are (Dietzfelbinger 1996, Universal Hashing and k-wise Independent Random
 * Variables via Integer Arithmetic without Primes). Immutable.
 */
public final class TupleHash {
    private static final long OF_THIS_RUN =
            (long) (Math.random() * (1L << 53)) ^ (long) (Math.random() * (1L << 53)) << 11;

    private final long[] factors;

    /**
     * The hash of this run.
     *
     * @param length of a tuple
     */
    public TupleHash(int length) {
        this(length, OF_THIS_RUN);
    }

    TupleHash(int length, long seed) {
        factors = new long[length + 1];
        for (int i = 0; i <= length; i++) factors[i] = mixed(seed + (i + 1) * 0x9E3779B97F4A7C15L);
    }

    /** The last steps of SplitMix (Steele, Lea and Flood 2014). */
    private static long mixed(long counter) {
        long z = (counter ^ counter >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }

    /**
     * Hashes a tuple.
     *
     * @param words that hold it
     * @param from index of its first word
     * @return any int
     */
    public int of(int[] words, int from) {
        int length = factors.length - 1;
        long sum = factors[length];
        for (int i = 0; i < length; i++) sum += (words[from + i] & 0xffffffffL) * factors[i];
        return (int) (sum >>> 32);
    }
}
