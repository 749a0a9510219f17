package org.jsmesh.codec.position;

import java.util.Arrays;
import org.jsmesh.codec.entropy.IntegerLog;
import org.jsmesh.codec.lod.LodMesh;

/**
 * Finds the vertex closest to a point among those whose mirror image is still missing, by a grid of blocks about as
 * wide as edges are long.
 */
final class UnpairedVertexGrid {
    /** Most vertices of a block that are looked at. Ordinary meshes have only a few. */
    private static final int MOST_IN_BLOCK = 64;

    private static final double REACH = 1.5; // blocks
    private final LodMesh mesh;
    private int[] heads = {-1}; // first vertex of a list, or −1
    private int[] next = new int[0];
    private boolean[] isPaired = new boolean[0];
    private int bits; // of a block's cells
    private double distance;

    UnpairedVertexGrid(LodMesh mesh) {
        this.mesh = mesh;
    }

    /** Starts with the vertices that are there now. */
    void begin(int[] pairs) {
        double longest = 0;
        for (int a = 0; a < 3; a++) {
            double low = 0;
            double high = 0;
            for (int v = 0; v < pairs.length; v++) {
                double x = cell(v, a);
                low = v == 0 || x < low ? x : low;
                high = v == 0 || x > high ? x : high;
            }
            longest = Math.max(longest, high - low);
        }
        double width = longest * 2 / Math.sqrt(pairs.length + 1);
        bits = 0;
        while (bits < 28 && 1 << bits < width) bits++;
        heads = new int[2 << IntegerLog.bits(pairs.length)];
        Arrays.fill(heads, -1);
        Arrays.fill(isPaired, false);
        for (int v = 0; v < pairs.length; v++) add(v, pairs[v] >= 0);
    }

    /** A vertex more. */
    void add(int vertex, boolean paired) {
        if (vertex >= next.length) {
            next = Arrays.copyOf(next, 2 * vertex + 64);
            isPaired = Arrays.copyOf(isPaired, next.length);
        }
        isPaired[vertex] = paired;
        if (paired) return;
        int list = list(cell(vertex, 0) >> bits, cell(vertex, 1) >> bits, cell(vertex, 2) >> bits);
        next[vertex] = heads[list];
        heads[list] = vertex;
    }

    /** Notes that the image of a vertex has come. */
    void pair(int vertex) {
        isPaired[vertex] = true;
    }

    boolean isPaired(int vertex) {
        return vertex < isPaired.length && isPaired[vertex];
    }

    /** The closest vertex no further away than {@code radius} cells, or −1. */
    int nearest(double x, double y, double z, double radius) {
        double reach = Math.min(radius, REACH * (1 << bits));
        int best = -1;
        double least = reach * reach;
        for (int i = block(x - reach); i <= block(x + reach); i++) {
            for (int j = block(y - reach); j <= block(y + reach); j++) {
                for (int k = block(z - reach); k <= block(z + reach); k++) {
                    int left = MOST_IN_BLOCK;
                    for (int v = heads[list(i, j, k)]; v >= 0 && left > 0; v = next[v], left--) {
                        if (isPaired[v]) continue;
                        double dx = cell(v, 0) - x;
                        double dy = cell(v, 1) - y;
                        double dz = cell(v, 2) - z;
                        double square = dx * dx + dy * dy + dz * dz;
                        boolean isFirst = best < 0 || v < best;
                        if (square < least || square <= least && isFirst) {
                            least = square;
                            best = v;
                        }
                    }
                }
            }
        }
        distance = Math.sqrt(least);
        return best;
    }

    /** Distance of the vertex found last. */
    double distance() {
        return distance;
    }

    private int block(double x) {
        return (int) Math.floor(x) >> bits;
    }

    private int cell(int vertex, int axis) {
        return mesh.places()[4 * mesh.firstFan(vertex) + axis];
    }

    private int list(int x, int y, int z) {
        return ((x * 0x9e3779b1 + y) * 0x9e3779b1 + z) * 0x9e3779b1 >>> 8 & heads.length - 1;
    }
}
