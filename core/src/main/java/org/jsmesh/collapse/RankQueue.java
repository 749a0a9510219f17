package org.jsmesh.collapse;

import java.util.Arrays;

/**
 * Numbers with ids. Finds the value at a rank, and sorts ids by value, roughly. Takes linear time. Values are not
 * negative.
 */
final class RankQueue {
    private static final int LOW = 32 + 21; // bits that do not count
    private long[] rows = new long[0]; // value << 32 | id
    private long[] other = rows;
    private final int[] counts = new int[1 << 63 - LOW];
    private int size;

    /** @param most that will be added until it is cleared again */
    void clear(int most) {
        size = 0;
        if (most <= rows.length) return;
        rows = other = new long[0]; // two of the old and two of the new would be too much
        rows = new long[most];
    }

    void add(float value) {
        add(value, 0);
    }

    void add(float value, int id) {
        rows[size++] = (long) Float.floatToRawIntBits(value) << 32 | id;
    }

    boolean isEmpty() {
        return size == 0;
    }

    int size() {
        return size;
    }

    /**
     * The value at a rank rounded down, the smallest at 0; the largest beyond the end. Leaves the queue in another
     * order.
     */
    float at(double rank) {
        int k = (int) Math.min(size - 1, rank);
        int low = 0;
        int high = size - 1;
        while (low < high) { // Hoare's selection
            long pivot = median(rows[low], rows[low + high >>> 1], rows[high]);
            int i = low;
            int j = high;
            while (i <= j) {
                while (rows[i] < pivot) i++;
                while (rows[j] > pivot) j--;
                if (i > j) break;
                long swapped = rows[i];
                rows[i++] = rows[j];
                rows[j--] = swapped;
            }
            if (k <= j) high = j;
            else if (k >= i) low = i;
            else break;
        }
        return Float.intBitsToFloat((int) (rows[k] >> 32));
    }

    private static long median(long a, long b, long c) {
        return Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
    }

    /**
     * Sorts by value, taking values that share exponent and two digits for the same, because ids that come together are
     * often close in memory.
     */
    void sort() {
        if (other.length < size) other = new long[rows.length];
        Arrays.fill(counts, 0);
        for (int i = 0; i < size; i++) counts[(int) (rows[i] >>> LOW)]++;
        int start = 0;
        for (int d = 0; d < counts.length; d++) {
            int n = counts[d];
            counts[d] = start;
            start += n;
        }
        for (int i = 0; i < size; i++) other[counts[(int) (rows[i] >>> LOW)]++] = rows[i];
        long[] sorted = other;
        other = rows;
        rows = sorted;
    }

    /** The id at a place. */
    int id(int place) {
        return (int) rows[place];
    }
}
