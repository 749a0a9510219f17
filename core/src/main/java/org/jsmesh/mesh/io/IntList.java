package org.jsmesh.mesh.io;

import java.util.Arrays;
import org.jsmesh.mesh.Sizes;

/** A growable array of int; floats are kept in it as their bits. */
final class IntList {
    private int[] values;
    private int size;

    IntList() {
        this(16);
    }

    IntList(int capacity) {
        values = new int[capacity];
    }

    /** Makes room for so many values in all. */
    void reserve(int capacity) {
        if (capacity > values.length) values = Arrays.copyOf(values, capacity);
    }

    void add(int value) {
        if (size == values.length) values = Arrays.copyOf(values, Sizes.more(size, "numbers of one kind"));
        values[size++] = value;
    }

    int get(int index) {
        return values[index];
    }

    void set(int index, int value) {
        values[index] = value;
    }

    int size() {
        return size;
    }

    int[] toArray() {
        return size == values.length ? values : Arrays.copyOf(values, size);
    }

    /** The values as floats whose bits they are. */
    float[] toFloats() {
        float[] floats = new float[size];
        for (int i = 0; i < size; i++) floats[i] = Float.intBitsToFloat(values[i]);
        return floats;
    }
}
