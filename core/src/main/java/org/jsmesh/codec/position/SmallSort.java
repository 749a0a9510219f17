package org.jsmesh.codec.position;

/** Sorts a few numbers without branches that no processor foretells: Batcher's odd-even merge sort, 1968. */
final class SmallSort {
    private static final int SIZE = 16;
    private static final int COMPARISONS = 63;
    private static final int[] LOW = new int[COMPARISONS];
    private static final int[] HIGH = new int[COMPARISONS];

    static {
        int c = 0;
        for (int p = 1; p < SIZE; p *= 2) {
            for (int k = p; k >= 1; k /= 2) {
                for (int i = k % p; i + k < SIZE; i++) {
                    boolean compares = (i - k % p) / k % 2 == 0 && i / (2 * p) == (i + k) / (2 * p);
                    if (!compares) continue;
                    LOW[c] = i;
                    HIGH[c++] = i + k;
                }
            }
        }
    }

    private SmallSort() {}

    /** Sorts the first numbers of an array that has room for at least 16. */
    static void sort(int[] numbers, int count) {
        if (count > SIZE) insert(numbers, count);
        else merge(numbers, count);
    }

    private static void merge(int[] numbers, int count) {
        for (int i = count; i < SIZE; i++) numbers[i] = Integer.MAX_VALUE;
        for (int c = 0; c < COMPARISONS; c++) {
            int a = numbers[LOW[c]];
            int b = numbers[HIGH[c]];
            numbers[LOW[c]] = Math.min(a, b);
            numbers[HIGH[c]] = Math.max(a, b);
        }
    }

    private static void insert(int[] numbers, int count) {
        for (int i = 1; i < count; i++) {
            int number = numbers[i];
            int j = i;
            for (; j > 0 && numbers[j - 1] > number; j--) numbers[j] = numbers[j - 1];
            numbers[j] = number;
        }
    }
}
