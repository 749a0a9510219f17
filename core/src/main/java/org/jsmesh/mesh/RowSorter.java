package org.jsmesh.mesh;

import java.util.Arrays;

/**
 * Sorts rows of ints, as unsigned numbers from the first column to the last. It sorts all rows by the first column (by
 * radix when they are many), then those that share it by the next.
 */
final class RowSorter {
    private static final int FEW = 24; // rows that are inserted one by one
    private static final int MANY = 2048; // rows worth a radix sort
    private static final int DIGIT = 11;
    private static final int ROW_BITS = 31; // below the value in the keys

    private final int[] rows;
    private final int width;
    private final int[] order;

    private RowSorter(int[] rows, int width, int[] order) {
        this.rows = rows;
        this.width = width;
        this.order = order;
    }

    /**
     * The order of {@code count} rows of {@code width} ints each: row numbers, smallest row first; equal rows keep
     * their order.
     */
    static int[] order(int[] rows, int width, int count) {
        int[] order = new int[count];
        order(rows, width, count, order);
        return order;
    }

    /** The same, into the first places of an array. */
    static void order(int[] rows, int width, int count, int[] order) {
        for (int i = 0; i < count; i++) order[i] = i;
        new RowSorter(rows, width, order).sort(0, count, 0);
    }

    /** Sorts a range of rows that are equal in the columns before. */
    private void sort(int from, int to, int firstColumn) {
        for (int column = firstColumn; column < width; column++) {
            if (to - from <= FEW) {
                insert(from, to, column);
                return;
            }
            if (areAlike(from, to, column)) continue;
            sortBy(from, to, column);
            int start = from;
            for (int i = from + 1; i <= to; i++) {
                if (i < to && value(i, column) == value(start, column)) continue;
                if (i - start > 1) sort(start, i, column + 1);
                start = i;
            }
            return;
        }
    }

    private int value(int i, int column) {
        return rows[order[i] * width + column];
    }

    private boolean areAlike(int from, int to, int column) {
        int first = value(from, column);
        for (int i = from + 1; i < to; i++) if (value(i, column) != first) return false;
        return true;
    }

    private void insert(int from, int to, int column) {
        for (int i = from + 1; i < to; i++) {
            int row = order[i];
            int j = i;
            for (; j > from && isLess(row, order[j - 1], column); j--) order[j] = order[j - 1];
            order[j] = row;
        }
    }

    private boolean isLess(int a, int b, int firstColumn) {
        for (int k = firstColumn; k < width; k++) {
            int x = rows[a * width + k];
            int y = rows[b * width + k];
            if (x != y) return x + Integer.MIN_VALUE < y + Integer.MIN_VALUE;
        }
        return false;
    }

    private void sortBy(int from, int to, int column) {
        int count = to - from;
        long[] keys = new long[count];
        for (int i = 0; i < count; i++) keys[i] = (value(from + i, column) & 0xffffffffL) << ROW_BITS | i;
        if (count < MANY) Arrays.sort(keys);
        else keys = radixSorted(keys);
        int[] before = Arrays.copyOfRange(order, from, to);
        for (int i = 0; i < count; i++) order[from + i] = before[(int) (keys[i] & Integer.MAX_VALUE)];
    }

    private static long[] radixSorted(long[] keys) {
        long[] from = keys;
        long[] to = new long[keys.length];
        for (int shift = ROW_BITS; shift < Long.SIZE - 1; shift += DIGIT) {
            int[] start = new int[(1 << DIGIT) + 1];
            int mask = (1 << DIGIT) - 1;
            for (long key : from) start[((int) (key >>> shift) & mask) + 1]++;
            if (start[((int) (from[0] >>> shift) & mask) + 1] == from.length) continue;
            for (int i = 0; i < mask; i++) start[i + 1] += start[i];
            for (long key : from) to[start[(int) (key >>> shift) & mask]++] = key;
            long[] t = from;
            from = to;
            to = t;
        }
        return from;
    }

    /** Are two rows equal? */
    static boolean equal(int[] rows, int width, int a, int b) {
        for (int i = 0; i < width; i++) if (rows[a * width + i] != rows[b * width + i]) return false;
        return true;
    }
}
