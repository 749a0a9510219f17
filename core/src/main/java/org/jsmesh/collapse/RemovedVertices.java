package org.jsmesh.collapse;

import java.util.Arrays;
import org.jsmesh.mesh.CornerTable;

/**
 * The vertices that were removed, each with the face that is closest to it now, as far as collapses tell. So the effect
 * of a further collapse on the distance from the original can be measured instead of guessed from planes. Points are
 * kept at the faces, as Ronfard and Rossignac 1996 keep planes, and Hoppe et al. 1993 points.
 */
final class RemovedVertices {
    private static final int NONE = -1;

    /** Share of the area of the faces at a vertex that belongs to the vertex. */
    static final double WEIGHT = 1. / 3;

    private final float[] positions;
    private final double factor;
    private final float[] weights;
    private final int[] first; // of the vertices at each face
    private final int[] next;
    private int[] moving = new int[64];

    /** @param weights of each vertex: original area gathered about it */
    RemovedVertices(UnitScale scale, float[] weights, int faces) {
        positions = scale.positions();
        factor = scale.factor();
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
        for (int i = 0; i < star.size && sum <= most; i++) {
            int face = CornerTable.face(star.corner[i]);
            if (face >= first.length) continue;
            for (int p = first[face]; p != NONE; p = next[p]) {
                sum += weights[p] * squared(fan, p, u);
            }
        }
        return WEIGHT * sum;
    }

    private double squared(FanDistance fan, int p, int u) {
        return fan.squared(offset(p, u, 0), offset(p, u, 1), offset(p, u, 2));
    }

    private double offset(int p, int u, int axis) {
        return ((double) positions[3 * p + axis] - positions[3 * u + axis]) * factor;
    }

    /**
     * Gives u and the vertices at its faces to the faces that are left when it collapses. The star is the one before
     * the collapse.
     */
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
            squared(fan, p, u);
            int face = CornerTable.face(star.corner[fan.nearest()]);
            next[p] = first[face];
            first[face] = p;
        }
    }
}
