package org.jsmesh.mesh;

/**
 * Hashes of keys that are a few ints. The factors differ from run to run, so that nobody can make a file whose keys all
 * meet in one place of a table, and looking one up takes as long as going through all of them (Crosby and Wallach 2003,
 * Denial of Service via Algorithmic Complexity Attacks). A table must not show in what order it holds its keys: results
 * are the same in each run. Immutable.
 *
 * <p>Two long keys share a hash with the chance 2<sup>−32</sup>, whatever they are (Dietzfelbinger 1996, Universal
 * Hashing and k-wise Independent Random Variables via Integer Arithmetic without Primes). Short ones are hashed without
 * longs, which are slow in a browser: of millions that are made for it, some hundreds may meet.
 */
public final class KeyHash {
    private static final long OF_THIS_RUN =
            (long) (Math.random() * (1L << 53)) ^ (long) (Math.random() * (1L << 53)) << 11;

    private final long[] factors;
    private final int start;
    private final int first;
    private final int second;

    /**
     * The hash of this run.
     *
     * @param words of a long key
     */
    public KeyHash(int words) {
        this(words, OF_THIS_RUN);
    }

    KeyHash(int words, long seed) {
        factors = new long[words + 1];
        for (int i = 0; i <= words; i++) factors[i] = mixed(seed + (i + 1) * 0x9E3779B97F4A7C15L);
        start = (int) factors[0];
        first = (int) (factors[0] >>> 32) | 1;
        second = (int) mixed(seed) | 1;
    }

    /** The last steps of SplitMix (Steele, Lea and Flood 2014). */
    private static long mixed(long counter) {
        long z = (counter ^ counter >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }

    /**
     * Hashes a key of two words.
     *
     * @param a the first
     * @param b the second
     * @return any int
     */
    public int of(int a, int b) {
        int hash = (a ^ start) * first;
        hash = ((hash ^ hash >>> 15) + b) * second;
        return hash ^ hash >>> 16;
    }

    /**
     * Hashes a key of three words.
     *
     * @param a the first
     * @param b the second
     * @param c the third
     * @return any int
     */
    public int of(int a, int b, int c) {
        return of(of(a, b), c);
    }

    /**
     * Hashes a long key.
     *
     * @param words that hold it
     * @param from index of its first word
     * @return any int
     */
    public int of(int[] words, int from) {
        int count = factors.length - 1;
        long sum = factors[count];
        for (int i = 0; i < count; i++) sum += (words[from + i] & 0xffffffffL) * factors[i];
        return (int) (sum >>> 32);
    }
}
