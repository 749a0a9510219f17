package org.jsmesh.encode.measure;

import org.jsmesh.mesh.Mesh;

/**
 * Points spread evenly over the surface of a mesh, and where on the surface of a level of detail the points nearest to
 * them lie: for comparing what the two look like there. The same meshes give the same points.
 */
public final class SurfaceProbe {
    private final double[] points;
    private final Places places;

    /**
     * Where some points lie on a mesh.
     *
     * @param faces one per point
     * @param weights three per point: how much each corner of the face counts, the sum is 1
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
        points = new SurfaceSamples(tree, samples).points();
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
        TriangleTree.Cursor cursor = new TriangleTree.Cursor(tree);
        for (int i = 0; i < n; i++) {
            int p = 3 * i;
            found.distances[i] = Math.sqrt(cursor.squaredDistance(points[p], points[p + 1], points[p + 2]));
            int triangle = cursor.nearest();
            found.faces[i] = tree.face(triangle);
            weigh(tree.corners(), 9 * triangle, p, found.weights);
        }
        return found;
    }

    /**
     * Barycentric coordinates of the point of a triangle nearest to a point: of its foot in the plane, or if that lies
     * outside of it, of the nearest foot on an edge.
     */
    private void weigh(float[] c, int t, int p, double[] weights) {
        double[] foot = new double[3];
        if (foot(c, t, p, foot)) {
            System.arraycopy(foot, 0, weights, p, 3);
            return;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int edge = 0; edge < 3; edge++) {
            int a = t + 3 * edge;
            int b = t + 3 * ((edge + 1) % 3);
            double along = 0;
            double length = 0;
            for (int k = 0; k < 3; k++) {
                double side = (double) c[b + k] - c[a + k];
                along += side * (points[p + k] - c[a + k]);
                length += side * side;
            }
            double u = length > 0 ? Math.max(0, Math.min(1, along / length)) : 0;
            double distance = 0;
            for (int k = 0; k < 3; k++) {
                double d = points[p + k] - c[a + k] - u * ((double) c[b + k] - c[a + k]);
                distance += d * d;
            }
            if (distance >= least) continue;
            least = distance;
            weights[p + edge] = 1 - u;
            weights[p + (edge + 1) % 3] = u;
            weights[p + (edge + 2) % 3] = 0;
        }
    }

    /** False when the foot lies outside of the triangle, or that has no area. */
    private boolean foot(float[] c, int t, int p, double[] weights) {
        double uu = 0;
        double uv = 0;
        double vv = 0;
        double pu = 0;
        double pv = 0;
        for (int k = 0; k < 3; k++) {
            double u = (double) c[t + 3 + k] - c[t + k];
            double v = (double) c[t + 6 + k] - c[t + k];
            double w = points[p + k] - c[t + k];
            uu += u * u;
            uv += u * v;
            vv += v * v;
            pu += w * u;
            pv += w * v;
        }
        double area = uu * vv - uv * uv;
        if (!(area > 0)) return false;
        weights[1] = (vv * pu - uv * pv) / area;
        weights[2] = (uu * pv - uv * pu) / area;
        weights[0] = 1 - weights[1] - weights[2];
        return weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0;
    }
}
