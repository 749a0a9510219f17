package org.jsmesh.display;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.BitSet;

/** An array for the graphics card that grows, with a note of the rows that have changed. Holds raw bits. */
final class LiveArray {
    private static final int LEAST_ROWS = 64;

    /** Numbers in a row: those of one render vertex, or of one face. */
    final int width;

    private int[] bits;
    private int rows;
    private final BitSet changed = new BitSet();

    LiveArray(int width) {
        this.width = width;
        bits = new int[width * LEAST_ROWS];
    }

    /** Makes sure that there are so many rows. */
    void reserve(int count) {
        if (count <= rows) return;
        if (count * width > bits.length) bits = Arrays.copyOf(bits, width * (count + count / 2));
        rows = count;
    }

    /** Numbers in all rows. */
    int count() {
        return width * rows;
    }

    int get(int row, int column) {
        return bits[width * row + column];
    }

    float number(int row, int column) {
        return Float.intBitsToFloat(bits[width * row + column]);
    }

    void set(int row, int column, int value) {
        int at = width * row + column;
        if (bits[at] == value) return;
        bits[at] = value;
        changed.set(row);
    }

    void set(int row, int column, float value) {
        set(row, column, Float.floatToRawIntBits(value));
    }

    /** Sets the first three numbers of a row. */
    void set(int row, float[] from, int at) {
        int to = width * row;
        int x = Float.floatToRawIntBits(from[at]);
        int y = Float.floatToRawIntBits(from[at + 1]);
        int z = Float.floatToRawIntBits(from[at + 2]);
        if (bits[to] == x && bits[to + 1] == y && bits[to + 2] == z) return;
        bits[to] = x;
        bits[to + 1] = y;
        bits[to + 2] = z;
        changed.set(row);
    }

    /** Takes over an array of a mesh. */
    void replace(RenderMesh mesh, int array) {
        reserve(mesh.count(array) / width);
        for (int i = 0; i < mesh.count(array); i++) set(i / width, i % width, mesh.bits(array, i));
    }

    /** Rows that have changed since the last {@link #settle}. */
    BitSet changed() {
        return changed;
    }

    void settle() {
        changed.clear();
    }

    /** Copies numbers from one on, as many as asked for. */
    void copy(int from, int count, ByteBuffer to) {
        to.asIntBuffer().put(bits, from, count);
        to.position(to.position() + 4 * count);
    }

    /** The same into an array. */
    void copy(int from, int count, int[] to, int at) {
        System.arraycopy(bits, from, to, at, count);
    }
}
