package org.jsmesh.mesh;

import java.util.Arrays;

/** A map from undirected edges to ids: open addressing over primitive arrays. */
public final class EdgeMap {
    private static final int EMPTY = -1;
    private static final int MOST_SLOTS = 1 << 30;
    private static final KeyHash HASH = KeyHash.OF_THIS_RUN;

    private long[] keys;
    private int[] values;
    private int size;

    /**
     * Makes an empty map, which grows.
     *
     * @param expected edges to make room for
     */
    public EdgeMap(int expected) {
        int capacity = (int) Math.min(MOST_SLOTS, Integer.highestOneBit(Math.max(8, expected)) * 2L);
        keys = new long[capacity];
        values = new int[capacity];
        Arrays.fill(values, EMPTY);
    }

    /** Forgets all edges. */
    public void clear() {
        Arrays.fill(values, EMPTY);
        size = 0;
    }

    /**
     * Sets the id of an edge.
     *
     * @param a one vertex
     * @param b the other vertex
     * @param id at least 0
     * @return the id that the edge had, or −1
     */
    public int put(int a, int b, int id) {
        if (4L * size >= 3L * keys.length) grow();
        long key = key(a, b);
        int i = find(key);
        int before = values[i];
        if (before == EMPTY) {
            keys[i] = key;
            size++;
        }
        values[i] = id;
        return before;
    }

    /**
     * Finds an edge.
     *
     * @param a one vertex
     * @param b the other vertex
     * @return the id of the edge, or −1
     */
    public int get(int a, int b) {
        return values[find(key(a, b))];
    }

    private static long key(int a, int b) {
        return a < b ? (long) a << 32 | b & 0xffffffffL : (long) b << 32 | a & 0xffffffffL;
    }

    private int find(long key) {
        int mask = keys.length - 1;
        int i = HASH.of((int) key, (int) (key >>> 32)) & mask;
        while (values[i] != EMPTY && keys[i] != key) i = i + 1 & mask;
        return i;
    }

    private void grow() {
        long[] oldKeys = keys;
        int[] oldValues = values;
        if (oldKeys.length == MOST_SLOTS) throw new TooLargeException(size + 1L, "edges", size);
        keys = new long[2 * oldKeys.length];
        values = new int[2 * oldKeys.length];
        Arrays.fill(values, EMPTY);
        for (int i = 0; i < oldKeys.length; i++) {
            if (oldValues[i] == EMPTY) continue;
            int at = find(oldKeys[i]);
            keys[at] = oldKeys[i];
            values[at] = oldValues[i];
        }
    }
}
