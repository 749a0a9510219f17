package org.jsmesh.codec.lod;

import java.util.Arrays;

/**
 * How large the arrays of a growing mesh are: twice as large as before, until they may as well be as large as they are
 * expected to become. So they are never more than four times as large as what has come, whatever a header claims, and
 * in the end not larger than needed.
 */
public final class ArrayGrowth {
    private static final int LEAST = 64;
    private static final int MARGIN = 8; // beyond what was expected, a part of 1/8

    private ArrayGrowth() {}

    /**
     * Room for more rows than there is room for.
     *
     * @param width numbers per row
     * @param needed rows
     * @param expected rows in the end
     */
    public static int[] rows(int[] rows, int width, int needed, int expected) {
        return Arrays.copyOf(rows, width * size(rows.length / width, needed, expected));
    }

    /** Rows to make room for. */
    static int size(int had, int needed, int expected) {
        if (needed > expected) return Math.max(LEAST, needed + needed / MARGIN);
        int size = Math.max(LEAST, Math.max(needed, 2 * had));
        return size > expected / 2 ? expected : size;
    }
}
