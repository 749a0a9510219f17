package org.jsmesh.collapse;

import org.jsmesh.mesh.Mesh;

/** Normals of the faces of a mesh, as long as twice their area, and the creases between faces. */
final class FaceNormals {
    private final double[] normals;
    private final double leastCosine;

    FaceNormals(Mesh mesh, double creaseDegrees) {
        leastCosine = StrictMath.cos(StrictMath.toRadians(creaseDegrees));
        normals = new double[3 * mesh.faces()];
        float[] p = mesh.positions();
        for (int f = 0; f < mesh.faces(); f++) {
            int a = 3 * mesh.vertex(f, 0);
            int b = 3 * mesh.vertex(f, 1);
            int c = 3 * mesh.vertex(f, 2);
            double ux = (double) p[b] - p[a];
            double uy = (double) p[b + 1] - p[a + 1];
            double uz = (double) p[b + 2] - p[a + 2];
            double vx = (double) p[c] - p[a];
            double vy = (double) p[c + 1] - p[a + 1];
            double vz = (double) p[c + 2] - p[a + 2];
            normals[3 * f] = uy * vz - uz * vy;
            normals[3 * f + 1] = uz * vx - ux * vz;
            normals[3 * f + 2] = ux * vy - uy * vx;
        }
    }

    /** Do two faces meet at more than the crease angle? Faces without area form no crease. */
    boolean isCrease(int f, int g) {
        double lengths = Math.sqrt(dot(f, f)) * Math.sqrt(dot(g, g));
        return dot(f, g) < leastCosine * lengths;
    }

    private double dot(int f, int g) {
        return normals[3 * f] * normals[3 * g]
                + normals[3 * f + 1] * normals[3 * g + 1]
                + normals[3 * f + 2] * normals[3 * g + 2];
    }

    void addTo(double[] sums, int at, int face) {
        for (int axis = 0; axis < 3; axis++) sums[at + axis] += normals[3 * face + axis];
    }
}
