package org.jsmesh.codec.position;

/**
 * Sorts a few numbers without branches that no processor foretells, by the network of 60 comparisons of Green, 1969.
 */
final class SmallSort {
    private static final int SIZE = 16;

    private SmallSort() {}

    /** Sorts the first numbers of an array that has room for at least 16. */
    static void sort(int[] numbers, int count) {
        if (count > SIZE) insert(numbers, count);
        else merge(numbers, count);
    }

    private static void merge(int[] n, int count) {
        for (int i = count; i < SIZE; i++) n[i] = Integer.MAX_VALUE;
        order(n, 0, 1);
        order(n, 2, 3);
        order(n, 4, 5);
        order(n, 6, 7);
        order(n, 8, 9);
        order(n, 10, 11);
        order(n, 12, 13);
        order(n, 14, 15);
        order(n, 0, 2);
        order(n, 1, 3);
        order(n, 4, 6);
        order(n, 5, 7);
        order(n, 8, 10);
        order(n, 9, 11);
        order(n, 12, 14);
        order(n, 13, 15);
        order(n, 0, 4);
        order(n, 1, 5);
        order(n, 2, 6);
        order(n, 3, 7);
        order(n, 8, 12);
        order(n, 9, 13);
        order(n, 10, 14);
        order(n, 11, 15);
        order(n, 0, 8);
        order(n, 1, 9);
        order(n, 2, 10);
        order(n, 3, 11);
        order(n, 4, 12);
        order(n, 5, 13);
        order(n, 6, 14);
        order(n, 7, 15);
        order(n, 5, 10);
        order(n, 6, 9);
        order(n, 3, 12);
        order(n, 13, 14);
        order(n, 4, 8);
        order(n, 7, 11);
        order(n, 1, 2);
        order(n, 1, 4);
        order(n, 7, 13);
        order(n, 2, 8);
        order(n, 11, 14);
        order(n, 2, 4);
        order(n, 5, 6);
        order(n, 9, 10);
        order(n, 11, 13);
        order(n, 3, 8);
        order(n, 7, 12);
        order(n, 6, 8);
        order(n, 10, 12);
        order(n, 3, 5);
        order(n, 7, 9);
        order(n, 3, 4);
        order(n, 5, 6);
        order(n, 7, 8);
        order(n, 9, 10);
        order(n, 11, 12);
        order(n, 6, 7);
        order(n, 8, 9);
    }

    private static void order(int[] n, int low, int high) {
        int a = n[low];
        int b = n[high];
        n[low] = Math.min(a, b);
        n[high] = Math.max(a, b);
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
