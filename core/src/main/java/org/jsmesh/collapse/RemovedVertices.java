package org.jsmesh.collapse;

import java.util.Arrays;
import org.jsmesh.mesh.CornerTable;

/**
 * The vertices that were removed, each with the face that is closest to it now, as far as collapses tell: what a further collapse does to the distance from the original can then be measured, instead of
 * being guessed from planes. Points are kept at the faces, as Ronfard and Rossignac 1996 keep planes, and Hoppe et al. 1993 points.
 */
final class RemovedVertices {
    private static final int NONE = -1;

    /** A third of the area of the faces at a vertex is its own. */
    static final double WEIGHT = 1. / 3;

    private final double[] positions;
    private final double[] weights;
    private final int[] first; // of the vertices at each face
    private final int[] next;
    private int[] moving = new int[64];

    /**
     * @param positions scaled, three per vertex
     * @param weights of each vertex: original area gathered about it
     */
    RemovedVertices(double[] positions, double[] weights, int faces) {
        this.positions = positions;
        this.weights = weights;
        first = new int[faces];
        next = new int[weights.length];
        Arrays.fill(first, NONE);
    }

    /**
     * The weighted sum of the squared distances after a collapse, of the star's vertices and of u itself.
     *
     * @param fan the faces that the collapse leaves
     * @param limit above which the sum does not matter
     */
    double cost(VertexStar star, int u, FanDistance fan, double limit) {
        double most = limit / WEIGHT;
        double sum = weights[u] * fan.squared(0, 0, 0);
        double x = positions[3 * u];
        double y = positions[3 * u + 1];
        double z = positions[3 * u + 2];
        for (int i = 0; i < star.size && sum <= most; i++) {
            int face = CornerTable.face(star.corner[i]);
            if (face >= first.length) continue;
            for (int p = first[face]; p != NONE; p = next[p]) {
                int at = 3 * p;
                sum += weights[p] * fan.squared(positions[at] - x, positions[at + 1] - y, positions[at + 2] - z);
            }
        }
        return WEIGHT * sum;
    }

    /** Gives u and the vertices at its faces to the faces that are left when it collapses. The star is that before. */
    void collapse(VertexStar star, int u, FanDistance fan) {
        int n = 0;
        moving[n++] = u;
        for (int i = 0; i < star.size; i++) {
            int face = CornerTable.face(star.corner[i]);
            if (face >= first.length) continue;
            for (int p = first[face]; p != NONE; p = next[p]) {
                if (n == moving.length) moving = Arrays.copyOf(moving, 2 * n);
                moving[n++] = p;
            }
            first[face] = NONE;
        }
        if (fan.isEmpty()) return;
        for (int i = 0; i < n; i++) {
            int p = moving[i];
            int at = 3 * p;
            fan.squared(
                    positions[at] - positions[3 * u],
                    positions[at + 1] - positions[3 * u + 1],
                    positions[at + 2] - positions[3 * u + 2]);
            int face = CornerTable.face(star.corner[fan.nearest()]);
            next[p] = first[face];
            first[face] = p;
        }
    }
}
