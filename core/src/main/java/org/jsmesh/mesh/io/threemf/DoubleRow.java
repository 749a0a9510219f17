package org.jsmesh.mesh.io.threemf;

import java.util.Arrays;

/** A growable array of double. */
final class DoubleRow {
    double[] values = new double[16];
    int size;

    void add(double value) {
        if (size == values.length) values = Arrays.copyOf(values, size + (size >> 1));
        values[size++] = value;
    }
}
