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
        return Arrays.copyOf(rows, Sizes.of(width, size(rows.length / width, needed, expected), "rows of numbers"));
    }

    /** Rows to make room for. */
    static int size(int had, int needed, int expected) {
        if (needed > expected) return Math.max(LEAST, needed + needed / MARGIN);
        int size = Math.max(LEAST, Math.max(needed, 2 * had));
        return size > expected / 2 ? expected : size;
    }
}
