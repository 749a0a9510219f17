package org.jsmesh.encode.measure;

/**
 * Finds triangles close to points where so many triangles overlap that going through all of them would take too long.
 * It looks at so many of them at most, in a tree, and does not look for ever: a distance may be too large, not too
 * small.
 */
final class CrowdedSurface {
    private static final int MOST_TRIANGLES = 1 << 18;

    /** Nodes and triangles of the tree that a point is compared with. */
    private static final int MOST_VISITS = 512;

    /** Triangles all over the surface that come first: where all boxes overlap, the tree leads to any of them. */
    private static final int SPREAD = 128;

    private final TriangleTree.Cursor cursor;
    private final TriangleTree tree;
    private final int step;

    CrowdedSurface(float[] positions, int[] triangles) {
        int faces = triangles.length / 3;
        step = 1 + (faces - 1) / MOST_TRIANGLES;
        int[] some = triangles;
        if (step > 1) {
            some = new int[3 * ((faces - 1) / step + 1)];
            for (int i = 0; i < some.length; i++) some[i] = triangles[3 * step * (i / 3) + i % 3];
        }
        tree = TriangleTree.of(positions, some);
        cursor = new TriangleTree.Cursor(tree, MOST_VISITS);
    }

    /** Squared distance from a point to a triangle that is close. */
    double squaredDistance(double x, double y, double z) {
        cursor.beginNear(x, y, z, SPREAD);
        return cursor.squaredDistance(x, y, z);
    }

    /** Three times the number of the triangle found last. */
    int triangle() {
        return 3 * step * tree.face(cursor.nearest());
    }
}
