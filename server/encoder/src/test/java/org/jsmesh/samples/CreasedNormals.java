package org.jsmesh.samples;

import java.util.ArrayList;
import java.util.List;

/** Normals per corner: the mean of the faces around a vertex that meet this face at less than the crease angle. */
final class CreasedNormals {
    private final double[][] faceNormals;
    private final List<List<Integer>> around = new ArrayList<>();
    private final double leastCosine;

    CreasedNormals(List<double[]> points, List<int[]> triangles, double creaseDegrees) {
        leastCosine = StrictMath.cos(creaseDegrees * StrictMath.PI / 180);
        faceNormals = new double[triangles.size()][];
        for (int i = 0; i < points.size(); i++) around.add(new ArrayList<>());
        for (int f = 0; f < faceNormals.length; f++) {
            int[] t = triangles.get(f);
            faceNormals[f] = normal(points.get(t[0]), points.get(t[1]), points.get(t[2]));
            for (int v : t) around.get(v).add(f);
        }
    }

    /** The unit normal of this face at this vertex. */
    double[] at(int face, int vertex) {
        double[] sum = new double[3];
        double[] mine = faceNormals[face];
        for (int other : around.get(vertex)) {
            double[] n = faceNormals[other];
            double cosine = (n[0] * mine[0] + n[1] * mine[1] + n[2] * mine[2]) / (length(n) * length(mine));
            if (other != face && !(cosine > leastCosine)) continue;
            for (int a = 0; a < 3; a++) sum[a] += n[a];
        }
        double length = length(sum);
        for (int a = 0; a < 3; a++) sum[a] /= length;
        return sum;
    }

    /** As long as twice the area, so that sums are weighted by it. */
    private static double[] normal(double[] a, double[] b, double[] c) {
        double ux = b[0] - a[0];
        double uy = b[1] - a[1];
        double uz = b[2] - a[2];
        double vx = c[0] - a[0];
        double vy = c[1] - a[1];
        double vz = c[2] - a[2];
        return new double[] {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
    }

    private static double length(double[] v) {
        return StrictMath.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
}
