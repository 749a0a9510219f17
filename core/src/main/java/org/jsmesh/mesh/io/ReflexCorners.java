package org.jsmesh.mesh.io;

import java.util.Arrays;

/**
 * The corners of a polygon where it turns the wrong way, in a tree of boxes: finds one within a triangle without going
 * through all of them. Boxes hold corners that are neighbours by the ranks of their coordinates, so that it does not
 * matter how unevenly they are spread.
 */
final class ReflexCorners {
    private static final int LEAF = 8;
    private static final int RANKS = Long.SIZE - 1;

    /** What rounding may do to a turn, in parts of its products; on the safe side. */
    private static final double ROUNDING = 1e-14;

    /** Triangles with less than this area, in parts of their size squared, may by rounding cover what is far away. */
    private static final double FLAT = 1e-9;

    /** Rounding makes no other triangle cover what is so far from it, in parts of its size. */
    private static final double MARGIN = 1e-3;

    private final double[] u;
    private final double[] v;
    private final double[] around = new double[4]; // least u, v, most u, v that a triangle may cover
    private final int[] order; // corners, leaf after leaf
    private final int[] placeOf; // of each corner in the order
    private final boolean[] isThere; // of each corner
    private final int leaves; // a power of two; node i has the children 2 i and 2 i + 1, leaves come last
    private final int[] counts; // of those that are there, per node
    private final double[] boxes; // least u, v, most u, v per node
    private final int[] stack = new int[2 * Integer.SIZE];
    private long visits;

    ReflexCorners(double[] u, double[] v, int corners) {
        this.u = u;
        this.v = v;
        order = order(u, v, corners);
        placeOf = new int[corners];
        for (int i = 0; i < corners; i++) placeOf[order[i]] = i;
        isThere = new boolean[corners];
        int some = 1;
        while (some * (long) LEAF < corners) some *= 2;
        leaves = some;
        counts = new int[2 * leaves];
        boxes = boxes();
    }

    /** Corners by a curve through the ranks of their coordinates. */
    private static int[] order(double[] u, double[] v, int corners) {
        int[] acrossRanks = ranks(u, corners);
        int[] alongRanks = ranks(v, corners);
        int indexBits = Integer.SIZE - Integer.numberOfLeadingZeros(corners);
        int bits = Math.min(indexBits, (RANKS - indexBits) / 2); // of a rank
        int[] order = new int[corners];
        long[] keys = new long[corners];
        for (int i = 0; i < corners; i++) {
            long code = spread(acrossRanks[i] >> indexBits - bits) | spread(alongRanks[i] >> indexBits - bits) << 1;
            keys[i] = code << indexBits | i;
        }
        Arrays.sort(keys);
        for (int i = 0; i < corners; i++) order[i] = (int) (keys[i] & (1L << indexBits) - 1);
        return order;
    }

    private static int[] ranks(double[] x, int corners) {
        long[] keys = new long[corners];
        for (int i = 0; i < corners; i++) {
            int bits = Float.floatToIntBits((float) x[i]); // coordinates are float32 numbers
            keys[i] = (long) (bits < 0 ? ~(bits & Integer.MAX_VALUE) : bits) << Integer.SIZE | i;
        }
        Arrays.sort(keys);
        int[] ranks = new int[corners];
        int rank = 0;
        for (int i = 0; i < corners; i++) {
            if (i > 0 && keys[i] >> Integer.SIZE != keys[i - 1] >> Integer.SIZE) rank = i;
            ranks[(int) keys[i]] = rank;
        }
        return ranks;
    }

    /** Puts a zero before each bit. */
    private static long spread(int bits) {
        long x = bits;
        x = (x | x << 16) & 0x0000ffff0000ffffL;
        x = (x | x << 8) & 0x00ff00ff00ff00ffL;
        x = (x | x << 4) & 0x0f0f0f0f0f0f0f0fL;
        x = (x | x << 2) & 0x3333333333333333L;
        return (x | x << 1) & 0x5555555555555555L;
    }

    private double[] boxes() {
        double[] all = new double[8 * leaves];
        for (int i = 0; i < all.length; i += 4) {
            all[i] = all[i + 1] = Double.POSITIVE_INFINITY;
            all[i + 2] = all[i + 3] = Double.NEGATIVE_INFINITY;
        }
        for (int i = 0; i < order.length; i++) {
            int at = 4 * (leaves + i / LEAF);
            all[at] = Math.min(all[at], u[order[i]]);
            all[at + 1] = Math.min(all[at + 1], v[order[i]]);
            all[at + 2] = Math.max(all[at + 2], u[order[i]]);
            all[at + 3] = Math.max(all[at + 3], v[order[i]]);
        }
        for (int at = 4 * (leaves - 1); at > 0; at -= 4) {
            for (int k = 0; k < 2; k++) all[at + k] = Math.min(all[2 * at + k], all[2 * at + 4 + k]);
            for (int k = 2; k < 4; k++) all[at + k] = Math.max(all[2 * at + k], all[2 * at + 4 + k]);
        }
        return all;
    }

    /** Adds a corner or takes it away. */
    void set(int corner, boolean isReflex) {
        if (isThere[corner] == isReflex) return;
        isThere[corner] = isReflex;
        for (int node = leaves + placeOf[corner] / LEAF; node > 0; node /= 2) counts[node] += isReflex ? 1 : -1;
    }

    boolean has(int corner) {
        return isThere[corner];
    }

    /** Nodes and corners looked at so far. */
    long visits() {
        return visits;
    }

    /** A corner that a triangle of others {@linkplain PolygonTriangulator#covers covers}, or −1. */
    int within(PolygonTriangulator polygon, int a, int b, int c) {
        measure(a, b, c);
        int depth = 0;
        stack[depth++] = 1;
        while (depth > 0) {
            int node = stack[--depth];
            visits++;
            if (counts[node] == 0
                    || isApart(4 * node)
                    || isBeside(node, a, b)
                    || isBeside(node, b, c)
                    || isBeside(node, c, a)) continue;
            if (node < leaves) {
                stack[depth++] = 2 * node;
                stack[depth++] = 2 * node + 1;
                continue;
            }
            int from = LEAF * (node - leaves);
            int to = Math.min(order.length, from + LEAF);
            for (int i = from; i < to; i++) {
                int p = order[i];
                visits++;
                if (isThere[p] && p != a && p != b && p != c && polygon.covers(a, b, c, p)) return p;
            }
        }
        return -1;
    }

    private void measure(int a, int b, int c) {
        around[0] = Math.min(u[a], Math.min(u[b], u[c]));
        around[1] = Math.min(v[a], Math.min(v[b], v[c]));
        around[2] = Math.max(u[a], Math.max(u[b], u[c]));
        around[3] = Math.max(v[a], Math.max(v[b], v[c]));
        double size = Math.max(around[2] - around[0], around[3] - around[1]);
        double area = (u[b] - u[a]) * (v[c] - v[a]) - (v[b] - v[a]) * (u[c] - u[a]);
        double margin = area > FLAT * size * size ? MARGIN * size : Double.POSITIVE_INFINITY;
        for (int k = 0; k < 4; k++) around[k] += k < 2 ? -margin : margin;
    }

    private boolean isApart(int box) {
        return boxes[box] > around[2]
                || boxes[box + 1] > around[3]
                || boxes[box + 2] < around[0]
                || boxes[box + 3] < around[1];
    }

    /** Does all of a box lie on the right of an edge, whatever is rounded? */
    private boolean isBeside(int node, int from, int to) {
        int at = 4 * node;
        double du = u[to] - u[from];
        double dv = v[to] - v[from];
        double lowU = boxes[at] - u[from];
        double lowV = boxes[at + 1] - v[from];
        double highU = boxes[at + 2] - u[from];
        double highV = boxes[at + 3] - v[from];
        double most = du * (du >= 0 ? highV : lowV) - dv * (dv >= 0 ? lowU : highU);
        double size = Math.abs(du) * Math.max(Math.abs(lowV), Math.abs(highV))
                + Math.abs(dv) * Math.max(Math.abs(lowU), Math.abs(highU));
        return most < -ROUNDING * size;
    }
}
