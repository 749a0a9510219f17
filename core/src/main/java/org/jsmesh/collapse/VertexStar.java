package org.jsmesh.collapse;

import java.util.Arrays;
import org.jsmesh.mesh.CornerTable;

/**
 * The faces around one vertex u, copied into small arrays: corners counter-clockwise, one-ring, edge vectors and face
 * normals. Entry i belongs to the edge from u to neighbour i and to the face on its left, between the neighbours i and
 * i + 1. Reused from vertex to vertex; not thread-safe.
 */
final class VertexStar {
    /** Most faces, dummy ones included, of a vertex that may be removed. */
    static final int MOST_FACES = 61;

    private final CollapseMesh mesh;
    private final float[] positions;
    private final double factor;

    final int[] corner = new int[MOST_FACES + 1];
    final int[] neighbour = new int[MOST_FACES + 1];
    final boolean[] sharp = new boolean[MOST_FACES + 1];
    /** Edge vectors; those to {@link CornerTable#OUTSIDE} mean nothing. */
    final double[] edge = new double[3 * (MOST_FACES + 1)];
    /** Normals of twice the face's area in length. */
    final double[] normal = new double[3 * (MOST_FACES + 1)];
    /** Their lengths; 0 for dummy faces. */
    final double[] normalLength = new double[MOST_FACES + 1];

    int size;
    int sharpEdges;
    boolean boundary;

    VertexStar(CollapseMesh mesh, UnitScale scale) {
        this.mesh = mesh;
        positions = scale.positions();
        factor = scale.factor();
    }

    /** Loads the ring of u. False when u has too many or too few faces. */
    boolean load(int u) {
        int[] data = mesh.table().data();
        int start = mesh.table().cornerOf(u);
        boundary = false;
        int n = 0;
        int c = start;
        do {
            if (n == MOST_FACES) return false;
            int x = data[CornerTable.next(c)];
            corner[n] = c;
            neighbour[n++] = x;
            boundary |= x == CornerTable.OUTSIDE;
            c = data[c + 4];
        } while (c != start);
        size = n;
        return n >= 3;
    }

    /** Computes which edges are sharp. The edge to {@link CornerTable#OUTSIDE} is not. */
    void findSharpEdges() {
        int n = size;
        sharpEdges = 0;
        if (!boundary && !mesh.hasWedges()) {
            Arrays.fill(sharp, 0, n, false);
            return;
        }
        for (int i = 0; i < n; i++) {
            int ahead = i + 1 == n ? 0 : i + 1;
            sharp[ahead] = neighbour[ahead] != CornerTable.OUTSIDE && mesh.isSharp(corner[i]);
            if (sharp[ahead]) sharpEdges++;
        }
    }

    /**
     * May u go to neighbour i? A feature vertex may go only along a feature, and a vertex of the boundary only along
     * the boundary.
     */
    boolean mayCollapseAlong(int i) {
        if (neighbour[i] == CornerTable.OUTSIDE) return false;
        if (sharpEdges == 0) return true;
        if (!sharp[i]) return false;
        return !boundary
                || neighbour[i + 1 == size ? 0 : i + 1] == CornerTable.OUTSIDE
                || neighbour[i == 0 ? size - 1 : i - 1] == CornerTable.OUTSIDE;
    }

    /** Computes edge vectors and normals. */
    void measure(int u) {
        float[] p = positions;
        int n = size;
        double ux = p[3 * u];
        double uy = p[3 * u + 1];
        double uz = p[3 * u + 2];
        for (int i = 0; i < n; i++) {
            int at = 3 * neighbour[i];
            if (at < 0) continue;
            edge[3 * i] = (p[at] - ux) * factor;
            edge[3 * i + 1] = (p[at + 1] - uy) * factor;
            edge[3 * i + 2] = (p[at + 2] - uz) * factor;
        }
        for (int i = 0; i < n; i++) {
            int ahead = i + 1 == n ? 0 : i + 1;
            normalLength[i] = 0;
            if (neighbour[i] < 0 || neighbour[ahead] < 0) continue;
            int a = 3 * i;
            int b = 3 * ahead;
            double nx = edge[a + 1] * edge[b + 2] - edge[a + 2] * edge[b + 1];
            double ny = edge[a + 2] * edge[b] - edge[a] * edge[b + 2];
            double nz = edge[a] * edge[b + 1] - edge[a + 1] * edge[b];
            normal[a] = nx;
            normal[a + 1] = ny;
            normal[a + 2] = nz;
            normalLength[i] = Math.sqrt(nx * nx + ny * ny + nz * nz);
        }
    }
}
