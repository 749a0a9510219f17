package org.jsmesh.mesh;

/** Sorts rows of ints, as unsigned numbers from the first column to the last, by least-significant-digit radix sort. */
final class RowSorter {
    private RowSorter() {}

    /** The order of {@code count} rows of {@code width} ints each: row numbers, smallest row first; equal rows keep their order. */
    static int[] order(int[] rows, int width, int count) {
        int[] order = new int[count];
        for (int i = 0; i < count; i++) order[i] = i;
        int[] other = new int[count];
        int digit = count < 4096 ? 8 : 16;
        int[] start = new int[(1 << digit) + 1];
        for (int column = width - 1; column >= 0; column--) {
            for (int shift = 0; shift < 32; shift += digit) {
                if (!sortBy(rows, width, column, shift, start, order, other)) continue;
                int[] t = order;
                order = other;
                other = t;
            }
        }
        return order;
    }

    /** One counting pass from order to other; false when all digits are equal. */
    private static boolean sortBy(int[] rows, int width, int column, int shift, int[] start, int[] order, int[] other) {
        int mask = start.length - 2;
        java.util.Arrays.fill(start, 0);
        for (int row : order) start[(rows[row * width + column] >>> shift & mask) + 1]++;
        if (order.length > 0 && start[(rows[order[0] * width + column] >>> shift & mask) + 1] == order.length)
            return false;
        for (int i = 0; i <= mask; i++) start[i + 1] += start[i];
        for (int row : order) other[start[rows[row * width + column] >>> shift & mask]++] = row;
        return true;
    }

    /** Are two rows equal? */
    static boolean equal(int[] rows, int width, int a, int b) {
        for (int i = 0; i < width; i++) if (rows[a * width + i] != rows[b * width + i]) return false;
        return true;
    }
}
