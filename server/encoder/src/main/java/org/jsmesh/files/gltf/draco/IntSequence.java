package org.jsmesh.files.gltf.draco;

import java.util.Arrays;

/** Integers, as many as there come. */
final class IntSequence {
    private int[] values = new int[16];
    private int size;

    void add(int value) {
        if (size == values.length) values = Arrays.copyOf(values, 2 * size);
        values[size++] = value;
    }

    int get(int i) {
        return values[i];
    }

    int removeLast() {
        return values[--size];
    }

    void setLast(int value) {
        values[size - 1] = value;
    }

    int size() {
        return size;
    }

    int[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
