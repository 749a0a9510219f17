package org.jsmesh.codec.lod;

import java.util.Arrays;
import org.jsmesh.mesh.Sizes;

/**
 * Sizes of the arrays of a growing mesh. An array becomes twice as large as before, or as large as expected in the end
 * where that is hardly more. So it is never more than four times as large as what has come, whatever a header claims,
 * and in the end it is not larger than needed.
 */
public final class ArrayGrowth {
    private static final int LEAST = 64;
    private static final int MARGIN = 8; // beyond what was expected, a part of 1/8

    private ArrayGrowth() {}

    /**
     * Returns an array with room for more rows.
     *
     * @param width numbers per row
     * @param needed rows
     * @param expected rows in the end
     */
    public static int[] rows(int[] rows, int width, int needed, int expected) {
        return Arrays.copyOf(rows, width * size(width, rows.length / width, needed, expected));
    }

    /**
     * Rows to make room for: no more than an array can hold, where those that are needed fit into one.
     *
     * @throws org.jsmesh.mesh.TooLargeException when they do not
     */
    static int size(int width, int had, int needed, int expected) {
        Sizes.of(width, needed & 0xffffffffL, "rows of numbers");
        return (int) Math.min(Sizes.MOST / width, proposed(had, needed, expected));
    }

    private static long proposed(int had, int needed, int expected) {
        if (needed > expected) return Math.max(LEAST, (long) needed + needed / MARGIN);
        long size = Math.max(LEAST, Math.max(needed, 2L * had));
        return size > expected / 2 ? expected : size;
    }
}
