package org.jsmesh.display;

import java.util.HashMap;
import java.util.Map;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;

/**
 * A normal per corner: that of the file where the wedge has one. Else it is the mean of the faces around the vertex,
 * weighted by area: those of the same smoothing group where the mesh has such groups, none but its own in group 0; else
 * without those that meet the corner's face at more than the crease angle.
 */
final class CornerNormals {
    private final Mesh mesh;
    private final double creaseCosine;
    private final float[] normals;

    /** Smoothing group of each face, 0 for none; or null. */
    private final int[] groups;

    /** Twice the area times the unit normal of each face, then the inverse of its length (0 for a degenerate face). */
    private final double[] faceNormals;

    private final StarNormals star = new StarNormals();

    /** @param creaseCosine cosine of the angle between faces above which an edge is a crease */
    CornerNormals(Mesh mesh, double creaseCosine) {
        this.mesh = mesh;
        this.creaseCosine = creaseCosine;
        FaceChannel smoothing = mesh.faceChannel(FaceChannel.SMOOTHING);
        boolean usable = smoothing != null
                && smoothing.components() == 1
                && !smoothing.type().isFloat();
        this.groups = usable ? smoothing.values() : null;
        this.normals = new float[3 * mesh.faceWedges().length];
        this.faceNormals = faceNormals();
        int[] starts = new int[mesh.vertices() + 1];
        int[] corners = cornersByVertex(starts);
        for (int v = 0; v < mesh.vertices(); v++) {
            if (groups == null || areOneGroup(corners, starts[v], starts[v + 1]))
                around(corners, starts[v], starts[v + 1]);
            else byGroup(corners, starts[v], starts[v + 1]);
        }
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
        for (int f = 0; f < mesh.faces(); f++)
            StarNormals.put(p, 3 * mesh.vertex(f, 0), 3 * mesh.vertex(f, 1), 3 * mesh.vertex(f, 2), result, 4 * f);
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
        star.begin();
        for (int i = from; i < to; i++) star.add(faceNormals, 4 * (corners[i] / 3));
        if (groups == null) star.compute(creaseCosine);
        else star.average();
        for (int i = from; i < to; i++) System.arraycopy(star.normals(), 3 * (i - from), normals, 3 * corners[i], 3);
    }

    /** The faces of each group around a vertex have one normal; a face of group 0 has its own. */
    private void byGroup(int[] corners, int from, int to) {
        Map<Integer, double[]> sums = new HashMap<>();
        double[] sum = null;
        for (int i = from; i < to; i++) {
            int face = corners[i] / 3;
            int group = groups[face];
            if (group == 0) {
                put(corners[i], faceNormals[4 * face], faceNormals[4 * face + 1], faceNormals[4 * face + 2]);
                continue;
            }
            if (sum == null || group != groups[corners[i - 1] / 3])
                sum = sums.computeIfAbsent(group, g -> new double[3]);
            for (int k = 0; k < 3; k++) sum[k] += faceNormals[4 * face + k];
        }
        for (int i = from; i < to && sum != null; i++) {
            double[] all = sums.get(groups[corners[i] / 3]);
            if (all != null) put(corners[i], all[0], all[1], all[2]);
        }
    }

    private boolean areOneGroup(int[] corners, int from, int to) {
        for (int i = from; i < to; i++)
            if (groups[corners[i] / 3] == 0 || groups[corners[i] / 3] != groups[corners[from] / 3]) return false;
        return true;
    }

    private void put(int corner, double x, double y, double z) {
        StarNormals.put(x, y, z, normals, 3 * corner);
    }

    private void takeGiven() {
        Channel given = given(mesh);
        if (given == null) return;
        int[] faceWedges = mesh.faceWedges();
        for (int c = 0; c < faceWedges.length; c++)
            if (isThere(given, faceWedges[c])) put(given, faceWedges[c], normals, c);
    }

    /** Whether a wedge has a normal: a vector without length is none. */
    static boolean isThere(Channel given, int wedge) {
        if (given.isAbsent(wedge)) return false;
        if (given.type() == Channel.Type.UINT8) return true;
        for (int k = 0; k < 3; k++) if (given.number(wedge, k) != 0) return true;
        return false;
    }

    /** The channel with normals, or null. */
    static Channel given(Mesh mesh) {
        Channel channel = mesh.channel(Channel.Semantic.NORMAL);
        return channel == null || channel.components() != 3 ? null : channel;
    }

    /** Writes the normal of a wedge in a file; bytes without a sign stand for −1 to 1. */
    static void put(Channel given, int wedge, float[] to, int vertex) {
        boolean bytes = given.type() == Channel.Type.UINT8;
        for (int k = 0; k < 3; k++)
            to[3 * vertex + k] = bytes ? (float) (given.values()[3 * wedge + k] / 127.5 - 1) : given.number(wedge, k);
    }
}
