package org.jsmesh.display;

import java.util.BitSet;

/**
 * The changed parts of some arrays: not too many, as each has its cost, so that small gaps between them are sent too.
 */
final class ChangedRanges {
    private static final int MOST = 256;
    private static final int LEAST_GAP = 8;

    private final int[] rows = new int[3 * MOST]; // array, first element, elements
    private int size;
    private int gap = LEAST_GAP;

    /**
     * Finds the ranges of all arrays.
     *
     * @param arrays some may be null
     * @param order in which their ranges are to come
     */
    void find(LiveArray[] arrays, int[] order) {
        gap = Math.max(LEAST_GAP, gap / 4);
        while (!fits(arrays, order)) gap *= 2;
    }

    private boolean fits(LiveArray[] arrays, int[] order) {
        size = 0;
        for (int a : order) if (arrays[a] != null && !add(a, arrays[a].width, arrays[a].changed())) return false;
        return true;
    }

    private boolean add(int array, int width, BitSet changed) {
        int from = changed.nextSetBit(0);
        while (from >= 0) {
            int end = changed.nextClearBit(from);
            int next = changed.nextSetBit(end);
            while (next >= 0 && next - end <= gap) {
                end = changed.nextClearBit(next);
                next = changed.nextSetBit(end);
            }
            if (size == MOST) return false;
            add(array, width * from, width * (end - from));
            from = next;
        }
        return true;
    }

    private void add(int array, int from, int count) {
        rows[3 * size] = array;
        rows[3 * size + 1] = from;
        rows[3 * size + 2] = count;
        size++;
    }

    int size() {
        return size;
    }

    int array(int range) {
        return rows[3 * range];
    }

    int first(int range) {
        return rows[3 * range + 1];
    }

    int count(int range) {
        return rows[3 * range + 2];
    }
}
