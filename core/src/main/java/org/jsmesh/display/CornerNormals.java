package org.jsmesh.display;

import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/**
 * A normal per corner: that of the file where the wedge has one. Else it is the mean of the faces around the vertex,
 * weighted by area, without those that meet the corner's face at more than the crease angle.
 */
final class CornerNormals {
    /** Around a vertex with more faces all of them are averaged: comparing each with each would take too long. */
    private static final int MOST_COMPARED = 64;

    private final Mesh mesh;
    private final double creaseCosine;
    private final float[] normals;

    /** Twice the area times the unit normal of each face, then the inverse of its length (0 for a degenerate face). */
    private final double[] faceNormals;

    /** @param creaseCosine cosine of the angle between faces above which an edge is a crease */
    CornerNormals(Mesh mesh, double creaseCosine) {
        this.mesh = mesh;
        this.creaseCosine = creaseCosine;
        this.normals = new float[3 * mesh.faceWedges().length];
        this.faceNormals = faceNormals();
        int[] starts = new int[mesh.vertices() + 1];
        int[] corners = cornersByVertex(starts);
        for (int v = 0; v < mesh.vertices(); v++) around(corners, starts[v], starts[v + 1]);
        takeGiven();
    }

    /** Whether a corner's normal is the one at {@code vertex} of an array of normals. */
    boolean equal(int corner, float[] others, int vertex) {
        return normals[3 * corner] == others[3 * vertex]
                && normals[3 * corner + 1] == others[3 * vertex + 1]
                && normals[3 * corner + 2] == others[3 * vertex + 2];
    }

    /** Writes the normal of a corner. */
    void copy(int corner, float[] to, int vertex) {
        System.arraycopy(normals, 3 * corner, to, 3 * vertex, 3);
    }

    private double[] faceNormals() {
        float[] p = mesh.positions();
        double[] result = new double[4 * mesh.faces()];
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
            double nx = uy * vz - uz * vy;
            double ny = uz * vx - ux * vz;
            double nz = ux * vy - uy * vx;
            double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            result[4 * f] = nx;
            result[4 * f + 1] = ny;
            result[4 * f + 2] = nz;
            result[4 * f + 3] = length > 0 ? 1 / length : 0;
        }
        return result;
    }

    private int[] cornersByVertex(int[] starts) {
        int[] faceWedges = mesh.faceWedges();
        int[] wedgeVertices = mesh.wedgeVertices();
        for (int wedge : faceWedges) starts[wedgeVertices[wedge] + 1]++;
        for (int v = 0; v < mesh.vertices(); v++) starts[v + 1] += starts[v];
        int[] at = starts.clone();
        int[] corners = new int[faceWedges.length];
        for (int c = 0; c < faceWedges.length; c++) corners[at[wedgeVertices[faceWedges[c]]]++] = c;
        return corners;
    }

    private void around(int[] corners, int from, int to) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = from; i < to; i++) {
            int f = 4 * (corners[i] / 3);
            x += faceNormals[f];
            y += faceNormals[f + 1];
            z += faceNormals[f + 2];
        }
        if (to - from > MOST_COMPARED || isSmooth(corners, from, to, x, y, z)) {
            for (int i = from; i < to; i++) put(corners[i], x, y, z);
        } else {
            for (int i = from; i < to; i++) compare(corners, from, to, corners[i]);
        }
    }

    /** True when every face lies within half the crease angle of the mean, hence no two of them form a crease. */
    private boolean isSmooth(int[] corners, int from, int to, double x, double y, double z) {
        double scale = Math.sqrt((1 + creaseCosine) / 2) * Math.sqrt(x * x + y * y + z * z);
        for (int i = from; i < to; i++) {
            int f = 4 * (corners[i] / 3);
            double dot = (x * faceNormals[f] + y * faceNormals[f + 1] + z * faceNormals[f + 2]) * faceNormals[f + 3];
            if (faceNormals[f + 3] > 0 && dot < scale) return false;
        }
        return true;
    }

    private void compare(int[] corners, int from, int to, int corner) {
        int g = 4 * (corner / 3);
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = from; i < to; i++) {
            int f = 4 * (corners[i] / 3);
            double dot = faceNormals[f] * faceNormals[g]
                    + faceNormals[f + 1] * faceNormals[g + 1]
                    + faceNormals[f + 2] * faceNormals[g + 2];
            if (dot * faceNormals[f + 3] * faceNormals[g + 3] < creaseCosine && faceNormals[g + 3] > 0) continue;
            x += faceNormals[f];
            y += faceNormals[f + 1];
            z += faceNormals[f + 2];
        }
        put(corner, x, y, z);
    }

    private void put(int corner, double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        boolean hasDirection = length > 0 && length < Double.POSITIVE_INFINITY;
        double scale = hasDirection ? 1 / length : 0;
        normals[3 * corner] = (float) (hasDirection ? x * scale : 0);
        normals[3 * corner + 1] = (float) (hasDirection ? y * scale : 0);
        normals[3 * corner + 2] = (float) (hasDirection ? z * scale : 1);
    }

    private void takeGiven() {
        Channel given = given(mesh);
        if (given == null) return;
        int[] faceWedges = mesh.faceWedges();
        for (int c = 0; c < faceWedges.length; c++)
            if (!given.isAbsent(faceWedges[c])) put(given, faceWedges[c], normals, c);
    }

    /** The channel with normals, or null. */
    static Channel given(Mesh mesh) {
        Channel channel = mesh.channel(Channel.Semantic.NORMAL);
        return channel == null || channel.components() != 3 ? null : channel;
    }

    /** Writes the normal of a wedge in a file; bytes stand for −1 to 1. */
    static void put(Channel given, int wedge, float[] to, int vertex) {
        int[] values = given.values();
        boolean floats = given.type() == Channel.Type.FLOAT32;
        for (int k = 0; k < 3; k++) {
            int raw = values[3 * wedge + k];
            if (floats) to[3 * vertex + k] = Float.intBitsToFloat(raw);
            else to[3 * vertex + k] = (float) (raw / 127.5 - 1);
        }
    }
}
