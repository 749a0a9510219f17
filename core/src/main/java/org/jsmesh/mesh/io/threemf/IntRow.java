package org.jsmesh.mesh.io.threemf;

import java.util.Arrays;

/** A growable array of int. */
final class IntRow {
    int[] values = new int[16];
    int size;

    void add(int value) {
        if (size == values.length) values = Arrays.copyOf(values, size + (size >> 1));
        values[size++] = value;
    }
}
