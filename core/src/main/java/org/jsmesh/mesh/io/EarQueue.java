package org.jsmesh.mesh.io;

import java.util.Arrays;

/**
 * The corners of a polygon that may be ears, in their order. Others are known to be none until one of their neighbours
 * goes, or the corner that is in their way.
 */
final class EarQueue {
    private static final int NONE = -1;

    private final long[][] levels; // bits: corners that may be ears; words of the level below with any bit
    private final int[] obstacle; // of each corner that it keeps from being an ear, or −1
    private final int[] firstKept; // by each corner
    private final int[] nextKept; // by the same corner
    private final int[] keptBefore;
    private int size;

    EarQueue(int corners) {
        int depth = 1;
        for (int n = corners; n > Long.SIZE; n = (n + Long.SIZE - 1) / Long.SIZE) depth++;
        levels = new long[depth][];
        int n = corners;
        for (int i = 0; i < depth; i++) {
            n = (n + Long.SIZE - 1) / Long.SIZE;
            levels[i] = new long[n];
        }
        obstacle = filled(corners);
        firstKept = filled(corners);
        nextKept = filled(corners);
        keptBefore = filled(corners);
        for (int c = 0; c < corners; c++) add(c);
    }

    private static int[] filled(int n) {
        int[] list = new int[n];
        Arrays.fill(list, NONE);
        return list;
    }

    /** A corner may be an ear now. */
    void add(int corner) {
        unlink(corner);
        long bit = 1L << corner;
        if ((levels[0][corner >> 6] & bit) != 0) return;
        size++;
        int at = corner;
        for (long[] level : levels) {
            level[at >> 6] |= 1L << at;
            at >>= 6;
        }
    }

    /** A corner is no ear for now, because it turns the wrong way. */
    void remove(int corner) {
        unlink(corner);
        long bit = 1L << corner;
        if ((levels[0][corner >> 6] & bit) == 0) return;
        size--;
        int at = corner;
        for (long[] level : levels) {
            level[at >> 6] &= ~(1L << at);
            if (level[at >> 6] != 0) return;
            at >>= 6;
        }
    }

    /** A corner is no ear while another one is in the way. */
    void remove(int corner, int other) {
        remove(corner);
        obstacle[corner] = other;
        nextKept[corner] = firstKept[other];
        if (firstKept[other] >= 0) keptBefore[firstKept[other]] = corner;
        firstKept[other] = corner;
    }

    /** A corner is not in the way any more. */
    void release(int other) {
        while (firstKept[other] >= 0) add(firstKept[other]);
    }

    private void unlink(int corner) {
        int other = obstacle[corner];
        if (other < 0) return;
        if (keptBefore[corner] >= 0) nextKept[keptBefore[corner]] = nextKept[corner];
        else firstKept[other] = nextKept[corner];
        if (nextKept[corner] >= 0) keptBefore[nextKept[corner]] = keptBefore[corner];
        obstacle[corner] = NONE;
        nextKept[corner] = NONE;
        keptBefore[corner] = NONE;
    }

    /** The first corner from one on, around the polygon, that may be an ear; −1 when there is none. */
    int next(int corner) {
        if (size == 0) return NONE;
        int found = nextFrom(corner);
        return found >= 0 ? found : nextFrom(0);
    }

    private int nextFrom(int corner) {
        int at = corner;
        int level = 0;
        while (true) { // up to a word with a bit behind the place
            long word = at >> 6 < levels[level].length ? levels[level][at >> 6] & -1L << at : 0;
            if (word != 0) {
                at = at & -Long.SIZE | Long.numberOfTrailingZeros(word);
                break;
            }
            at = (at >> 6) + 1;
            if (++level == levels.length) return NONE;
        }
        while (level > 0) at = at << 6 | Long.numberOfTrailingZeros(levels[--level][at]);
        return at;
    }
}
