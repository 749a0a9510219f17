package org.jsmesh.test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/** A mesh in the making: vertices, faces, and charts or materials of faces. */
final class MeshParts {
    final List<double[]> points = new ArrayList<>();
    List<int[]> faces = new ArrayList<>();
    int[] materials;
    /** Faces of different charts share no wedge. */
    int[] charts;
    /** Do charts differ in normals, not in texture coordinates? */
    boolean normals;

    void vertex(double x, double y, double z) {
        points.add(new double[] {x, y, z});
    }

    void face(int a, int b, int c) {
        faces.add(new int[] {a, b, c});
    }

    void quad(int a, int b, int c, int d) {
        face(a, b, c);
        face(a, c, d);
    }

    void dropFaces(Random random, double share) {
        faces.removeIf(f -> random.nextDouble() < share);
    }

    Mesh build() {
        float[] positions = new float[3 * points.size()];
        for (int i = 0; i < positions.length; i++) positions[i] = (float) points.get(i / 3)[i % 3];
        int[] faceWedges = new int[3 * faces.size()];
        for (int i = 0; i < faceWedges.length; i++) faceWedges[i] = faces.get(i / 3)[i % 3];
        MeshBuilder builder = new MeshBuilder().positions(positions).faceWedges(faceWedges);
        if (materials != null) {
            int most = Arrays.stream(materials).max().orElse(-1);
            List<Material> list = new ArrayList<>();
            for (int i = 0; i <= most; i++) list.add(Material.named("m" + i));
            builder.faceMaterials(materials).materials(list);
        }
        if (charts != null) addSeams(builder, faceWedges, positions);
        return builder.build();
    }

    private void addSeams(MeshBuilder builder, int[] faceWedges, float[] positions) {
        int chartCount = Arrays.stream(charts).max().orElse(0) + 1;
        int[] wedgeOf = new int[points.size() * chartCount];
        List<Integer> vertices = new ArrayList<>();
        List<Integer> values = new ArrayList<>();
        for (int i = 0; i < faceWedges.length; i++) {
            int v = faceWedges[i];
            int key = v * chartCount + charts[i / 3];
            if (wedgeOf[key] == 0) {
                vertices.add(v);
                values.add(Float.floatToIntBits(positions[3 * v] + charts[i / 3]));
                values.add(Float.floatToIntBits(positions[3 * v + 1]));
                if (normals) values.add(Float.floatToIntBits(charts[i / 3] % 3));
                wedgeOf[key] = vertices.size();
            }
            faceWedges[i] = wedgeOf[key] - 1;
        }
        builder.wedgeVertices(vertices.stream().mapToInt(i -> i).toArray())
                .channels(List.of(new Channel(
                        normals ? Channel.Semantic.NORMAL : Channel.Semantic.TEXCOORD,
                        normals ? "normal" : "uv",
                        normals ? 3 : 2,
                        Channel.Type.FLOAT32,
                        values.stream().mapToInt(i -> i).toArray(),
                        null)));
    }
}
