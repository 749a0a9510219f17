package org.jsmesh.mesh;

/**
 * Hashes of keys of two or three ints. The factors differ from run to run, so that nobody can make a file whose keys
 * all meet in one place of a table, and looking one up takes as long as going through all of them (Crosby and Wallach
 * 2003, Denial of Service via Algorithmic Complexity Attacks): of millions of keys that are made for it, some hundreds
 * may. A table must not show in what order it holds its keys: results are the same in each run. There are no longs,
 * which are slow in a browser; {@link TupleHash} is for longer keys. Immutable.
 */
public final class KeyHash {
    /** The hash of this run. */
    public static final KeyHash OF_THIS_RUN = new KeyHash(random(), random(), random());

    private final int start;
    private final int first;
    private final int second;

    /** Of the factors, all bits but the last count. */
    KeyHash(int start, int first, int second) {
        this.start = start;
        this.first = first | 1;
        this.second = second | 1;
    }

    private static int random() {
        return (int) (Math.random() * 4294967296. - 2147483648.);
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
}
