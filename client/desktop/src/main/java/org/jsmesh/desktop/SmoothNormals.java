package org.jsmesh.desktop;

import org.jsmesh.mesh.Mesh;

/**
 * Vertex normals for meshes that bring none: the sum of the cross products of the faces around a vertex, so that each
 * face counts by its area.
 */
final class SmoothNormals {
    private SmoothNormals() {}

    /**
     * @param unit x, y, z of each vertex in unit space, where no product of coordinates overflows
     * @return x, y, z of a unit normal for each vertex; (0, 0, 1) where faces cancel out or none is
     */
    static float[] of(Mesh mesh, float[] unit) {
        double[] sum = new double[unit.length];
        for (int f = 0; f < mesh.faces(); f++) {
            int a = 3 * mesh.vertex(f, 0);
            int b = 3 * mesh.vertex(f, 1);
            int c = 3 * mesh.vertex(f, 2);
            double ux = unit[b] - unit[a];
            double uy = unit[b + 1] - unit[a + 1];
            double uz = unit[b + 2] - unit[a + 2];
            double vx = unit[c] - unit[a];
            double vy = unit[c + 1] - unit[a + 1];
            double vz = unit[c + 2] - unit[a + 2];
            double nx = uy * vz - uz * vy;
            double ny = uz * vx - ux * vz;
            double nz = ux * vy - uy * vx;
            add(sum, a, nx, ny, nz);
            add(sum, b, nx, ny, nz);
            add(sum, c, nx, ny, nz);
        }
        float[] normals = new float[unit.length];
        for (int i = 0; i < sum.length; i += 3) {
            double length = Math.sqrt(sum[i] * sum[i] + sum[i + 1] * sum[i + 1] + sum[i + 2] * sum[i + 2]);
            if (length > 0) {
                normals[i] = (float) (sum[i] / length);
                normals[i + 1] = (float) (sum[i + 1] / length);
                normals[i + 2] = (float) (sum[i + 2] / length);
            } else {
                normals[i + 2] = 1;
            }
        }
        return normals;
    }

    private static void add(double[] sum, int at, double x, double y, double z) {
        sum[at] += x;
        sum[at + 1] += y;
        sum[at + 2] += z;
    }
}
