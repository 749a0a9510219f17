package org.jsmesh.codec;

import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.TriangleDistance;

/**
 * Measures how far vertex splits move the surface: the distance of each new vertex from the faces that were there
 * before, in cells.
 */
final class SplitSteps {
    private final LodMesh mesh;
    private double largest; // squared

    SplitSteps(LodMesh mesh) {
        this.mesh = mesh;
    }

    /**
     * Adds the split that made a fan vertex with the ring {@code list[from .. to − 1]}. The last vertex of the ring is
     * the one that was split; negative: outside.
     */
    void add(int fan, int[] list, int from, int to) {
        int[] at = mesh.places();
        int parent = 4 * list[to - 1];
        int x = at[4 * fan];
        int y = at[4 * fan + 1];
        int z = at[4 * fan + 2];
        double nearest = Double.POSITIVE_INFINITY;
        double nearestEdge = Double.POSITIVE_INFINITY;
        // before, the faces around the new vertex were one fan about the one that was split
        for (int i = from; i < to - 1; i++) {
            int b = list[i];
            if (b < 0) continue;
            int c = i + 1 < to - 1 ? list[i + 1] : -1;
            if (c >= 0) nearest = Math.min(nearest, TriangleDistance.squared(at, parent, 4 * b, 4 * c, x, y, z));
            else nearestEdge = Math.min(nearestEdge, TriangleDistance.squared(at, parent, 4 * b, 4 * b, x, y, z));
        }
        if (nearest == Double.POSITIVE_INFINITY) nearest = nearestEdge; // an ear: it stood on an edge
        if (nearest > largest && nearest < Double.POSITIVE_INFINITY) largest = nearest;
    }

    /** The surface has grown to so many cells away from where it was. */
    void add(double distance) {
        largest = Math.max(largest, distance * distance);
    }

    double largest() {
        return Math.sqrt(largest);
    }

    void forget() {
        largest = 0;
    }
}
