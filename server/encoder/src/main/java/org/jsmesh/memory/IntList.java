package org.jsmesh.memory;

import java.io.IOException;
import java.util.Arrays;

/** Numbers out of a file that nobody has checked, so not more than {@value #MOST} of them. */
final class IntList {
    static final int MOST = 1 << 20;

    private int[] numbers = new int[16];
    private int size;

    int size() {
        return size;
    }

    void add(int number) throws IOException {
        if (size == MOST) throw new IOException("more than " + MOST + " numbers of a kind");
        if (size == numbers.length) numbers = Arrays.copyOf(numbers, 2 * size);
        numbers[size++] = number;
    }

    /** A number, or another one where there is no such place. */
    int get(int at, int otherwise) {
        return at >= 0 && at < size ? numbers[at] : otherwise;
    }

    int removeLast() {
        return numbers[--size];
    }
}
