package org.jsmesh.mesh;

/**
 * Items sorted by a key of a small range. First the user counts every key, then adds every item in the same order.
 * Items of a key keep their order. Two passes through memory replace the cache miss that a hash table has per look-up.
 */
final class Buckets {
    private final int[] ends; // while adding: where the next item of key − 1 goes; then where those of key begin
    private int[] items;

    /** @param keys are 0 .. keys − 1 */
    Buckets(int keys) {
        ends = new int[keys + 2];
    }

    /** Announces an item. */
    void count(int key) {
        ends[key + 2]++;
    }

    /** Begins to add. */
    void lay() {
        for (int k = 2; k < ends.length; k++) ends[k] += ends[k - 1];
        items = new int[ends[ends.length - 1]];
    }

    /** Adds an item that was announced. */
    void add(int key, int item) {
        items[ends[key + 1]++] = item;
    }

    /** All items, key after key. Shared. */
    int[] items() {
        return items;
    }

    /** First place of a key's items in {@link #items}. */
    int start(int key) {
        return ends[key];
    }

    /** Behind the last item of a key. */
    int end(int key) {
        return ends[key + 1];
    }
}
