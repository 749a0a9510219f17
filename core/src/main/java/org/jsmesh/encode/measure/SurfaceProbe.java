package org.jsmesh.encode.measure;

import org.jsmesh.mesh.Mesh;

/**
 * Points spread evenly over the surface of a mesh, and the points nearest to them on the surface of a level of detail.
 * They serve to compare what the two look like there. The same meshes give the same points.
 */
public final class SurfaceProbe {
    private final double[] points;
    private final Places places;

    /**
     * Where some points lie on a mesh.
     *
     * @param faces one per point
     * @param weights three per point: the weight of each corner of the face; the sum is 1
     * @param distances from the points asked for, in the mesh's units
     */
    public record Places(int[] faces, double[] weights, double[] distances) {
        /** Number of points. */
        public int size() {
            return faces.length;
        }
    }

    /**
     * @param original with at least one face
     * @param samples points to spread
     */
    public SurfaceProbe(Mesh original, int samples) {
        TriangleTree tree = tree(original);
        points = tree.surface().strew(samples);
        places = nearest(tree);
    }

    /** Where the points lie on the original. */
    public Places original() {
        return places;
    }

    /** Where the nearest points lie on a level of detail, which has at least one face. */
    public Places on(Mesh level) {
        return nearest(tree(level));
    }

    private static TriangleTree tree(Mesh mesh) {
        int[] triangles = new int[3 * mesh.faces()];
        for (int i = 0; i < triangles.length; i++) triangles[i] = mesh.wedgeVertices()[mesh.faceWedges()[i]];
        return new TriangleTree(mesh.positions(), triangles, mesh.faces());
    }

    private Places nearest(TriangleTree tree) {
        int n = points.length / 3;
        Places found = new Places(new int[n], new double[3 * n], new double[n]);
        ClosestPoint closest = new ClosestPoint();
        TriangleTree.Cursor cursor = new TriangleTree.Cursor(tree);
        for (int i = 0; i < n; i++) {
            int p = 3 * i;
            found.distances[i] = Math.sqrt(cursor.squaredDistance(points[p], points[p + 1], points[p + 2]));
            int triangle = cursor.nearest();
            found.faces[i] = tree.face(triangle);
            closest.find(tree.corners(), 9 * triangle, points[p], points[p + 1], points[p + 2]);
            System.arraycopy(closest.shares, 0, found.weights, p, 3);
        }
        return found;
    }
}
