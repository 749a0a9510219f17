package org.jsmesh.archive;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/** Gives meshes attributes to test with. */
final class AttributedMeshes {
    private AttributedMeshes() {}

    static Mesh withNormals(Mesh bare, float[] normals, BitSet absent) {
        int[] bits = new int[normals.length];
        for (int i = 0; i < bits.length; i++) bits[i] = Float.floatToRawIntBits(normals[i]);
        return with(bare, new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, bits, absent));
    }

    static Mesh with(Mesh bare, Channel channel) {
        return new MeshBuilder()
                .positions(bare.positions())
                .faceWedges(bare.faceWedges())
                .channels(List.of(channel))
                .build();
    }

    /**
     * Normals per wedge, in plain arithmetic.
     *
     * @param weights of the faces about a wedge: {@code area}, {@code angle} or {@code uniform}
     * @param unit whether they have unit length
     */
    static float[] normals(Mesh mesh, String weights, boolean unit) {
        double[] sum = new double[3 * mesh.wedges()];
        for (int f = 0; f < mesh.faces(); f++) {
            for (int j = 0; j < 3; j++) {
                double[] u = edge(mesh, f, j, (j + 1) % 3);
                double[] v = edge(mesh, f, j, (j + 2) % 3);
                double[] n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
                double angle = Math.acos(dot(u, v) / Math.sqrt(dot(u, u) * dot(v, v)));
                double area = Math.sqrt(dot(n, n));
                double factor = weights.equals("area") ? 1 : (weights.equals("angle") ? angle : 1) / area;
                for (int k = 0; k < 3; k++) sum[3 * mesh.faceWedges()[3 * f + j] + k] += n[k] * factor;
            }
        }
        float[] normals = new float[sum.length];
        for (int i = 0; i < sum.length; i++) {
            double[] n = Arrays.copyOfRange(sum, i - i % 3, i - i % 3 + 3);
            normals[i] = (float) (unit ? sum[i] / Math.sqrt(dot(n, n)) : sum[i]);
        }
        return normals;
    }

    private static double[] edge(Mesh mesh, int face, int from, int to) {
        double[] e = new double[3];
        for (int k = 0; k < 3; k++)
            e[k] = (double) mesh.positions()[3 * mesh.vertex(face, to) + k]
                    - mesh.positions()[3 * mesh.vertex(face, from) + k];
        return e;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
