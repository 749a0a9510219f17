package org.jsmesh.display;

import java.util.Arrays;

/**
 * The normals of the corners around one vertex: the mean of the faces around it, weighted by area, without those that
 * meet the corner's own face at more than the crease angle.
 */
final class StarNormals {
    /** Around a vertex with more faces all of them are averaged: comparing each with each would take too long. */
    private static final int MOST_COMPARED = 64;

    /** What rounding may do to the cosine of an angle. */
    private static final double ROUNDING = 1e-6;

    /** Twice the area times the unit normal of each face, then the inverse of its length (0 for a degenerate face). */
    private double[] faces = new double[4 * MOST_COMPARED];

    private float[] normals = new float[3 * MOST_COMPARED];
    private int size;
    private double creaseCosine;
    private final double[] sum = new double[3];
    private double steadyUpTo;

    /** Starts with no face. */
    void begin() {
        size = 0;
    }

    /** Adds a face by the places of its vertices in an array of coordinates. */
    void add(float[] p, int a, int b, int c) {
        reserve();
        put(p, a, b, c, faces, 4 * size++);
    }

    /** Adds a face that {@link #put} has measured. */
    void add(double[] measured, int at) {
        reserve();
        System.arraycopy(measured, at, faces, 4 * size++, 4);
    }

    private void reserve() {
        if (4 * size < faces.length) return;
        faces = Arrays.copyOf(faces, 2 * faces.length);
        normals = Arrays.copyOf(normals, 2 * normals.length);
    }

    /** Writes twice the area times the unit normal of a face, then the inverse of its length. */
    static void put(float[] p, int a, int b, int c, double[] to, int at) {
        double ux = (double) p[b] - p[a];
        double uy = (double) p[b + 1] - p[a + 1];
        double uz = (double) p[b + 2] - p[a + 2];
        double vx = (double) p[c] - p[a];
        double vy = (double) p[c + 1] - p[a + 1];
        double vz = (double) p[c + 2] - p[a + 2];
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        to[at] = nx;
        to[at + 1] = ny;
        to[at + 2] = nz;
        to[at + 3] = length > 0 ? 1 / length : 0;
    }

    /** Gives all corners the mean of the faces. */
    void average() {
        steadyUpTo = Double.POSITIVE_INFINITY;
        addUp();
        for (int i = 0; i < size; i++) put(i, sum[0], sum[1], sum[2]);
    }

    /**
     * Gives each corner the mean of the faces that are on its side of the creases.
     *
     * @param cosine of the angle between faces above which an edge is a crease
     */
    void compute(double cosine) {
        creaseCosine = cosine;
        if (size > MOST_COMPARED) {
            average();
            return;
        }
        addUp();
        if (isSmooth()) {
            for (int i = 0; i < size; i++) put(i, sum[0], sum[1], sum[2]);
        } else {
            steadyUpTo = Double.POSITIVE_INFINITY;
            for (int i = 0; i < size; i++) compare(i);
        }
    }

    private void addUp() {
        Arrays.fill(sum, 0);
        for (int f = 0; f < 4 * size; f += 4) for (int a = 0; a < 3; a++) sum[a] += faces[f + a];
    }

    /** True when every face lies within half the crease angle of the mean, hence no two of them form a crease. */
    private boolean isSmooth() {
        double x = sum[0];
        double y = sum[1];
        double z = sum[2];
        double length = Math.sqrt(x * x + y * y + z * z);
        double scale = Math.sqrt((1 + creaseCosine) / 2) * length;
        double least = Double.POSITIVE_INFINITY;
        for (int f = 0; f < 4 * size; f += 4) {
            double dot = (x * faces[f] + y * faces[f + 1] + z * faces[f + 2]) * faces[f + 3];
            if (faces[f + 3] > 0 && dot < least) least = dot;
        }
        double share = least / length;
        steadyUpTo = length > 0 ? 2 * share * share - 1 - ROUNDING : Double.POSITIVE_INFINITY;
        return !(least < scale);
    }

    private void compare(int corner) {
        int g = 4 * corner;
        double x = 0;
        double y = 0;
        double z = 0;
        for (int f = 0; f < 4 * size; f += 4) {
            double dot = faces[f] * faces[g] + faces[f + 1] * faces[g + 1] + faces[f + 2] * faces[g + 2];
            double cosine = dot * faces[f + 3] * faces[g + 3];
            if (faces[g + 3] > 0) {
                if (cosine < creaseCosine) continue;
                if (cosine - ROUNDING < steadyUpTo) steadyUpTo = cosine - ROUNDING;
            }
            x += faces[f];
            y += faces[f + 1];
            z += faces[f + 2];
        }
        put(corner, x, y, z);
    }

    /**
     * The crease cosine up to which the normals stay, if none of the faces changes. Where it is below the present one,
     * it says nothing.
     */
    double steadyUpTo() {
        return steadyUpTo;
    }

    private void put(int corner, double x, double y, double z) {
        put(x, y, z, normals, 3 * corner);
    }

    /** Writes a unit vector; (0, 0, 1) where the given one has no direction. */
    static void put(double x, double y, double z, float[] to, int at) {
        double length = Math.sqrt(x * x + y * y + z * z);
        boolean hasDirection = length > 0 && length < Double.POSITIVE_INFINITY;
        double scale = hasDirection ? 1 / length : 0;
        to[at] = (float) (hasDirection ? x * scale : 0);
        to[at + 1] = (float) (hasDirection ? y * scale : 0);
        to[at + 2] = (float) (hasDirection ? z * scale : 1);
    }

    /** Three numbers for each corner, in the order in which the faces were added. */
    float[] normals() {
        return normals;
    }
}
