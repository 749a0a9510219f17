package org.jsmesh.app.paper;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.collapse.ScalarAttributes;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/** Sharp edges and base edges of a mesh (section 3 of the paper), as dark bars on its surface. */
final class BaseEdges {
    /** Of the diagonal. */
    private static final double RADIUS = .0022;

    private static final int SIDES = 3;

    private BaseEdges() {}

    /** Ends of the edges that are sharp or whose weight is above the threshold. */
    static List<int[]> of(Mesh mesh, double threshold) {
        CollapseMesh collapsing = new CollapseMesh(mesh);
        CornerTable table = collapsing.table();
        ScalarAttributes attributes = new ScalarAttributes(mesh, table);
        List<int[]> edges = new ArrayList<>();
        for (int f = 0; f < mesh.faces(); f++) {
            for (int k = 0; k < 3; k++) {
                int c = CornerTable.STRIDE * f + k;
                int a = table.vertex(c);
                int b = table.vertex(CornerTable.previous(c));
                boolean isBoundary = CornerTable.face(table.swing(c)) >= mesh.faces();
                if (a > b && !isBoundary) continue; // it is met from both ends
                if (attributes.isSharp(c) || attributes.weight(c) > threshold)
                    edges.add(new int[] {collapsing.vertexOf()[a], collapsing.vertexOf()[b]});
            }
        }
        return edges;
    }

    /** The mesh in one light material, with the edges upon it. */
    static Mesh drawn(Mesh mesh, List<int[]> edges) {
        float[] b = mesh.bounds();
        double radius = RADIUS * Math.sqrt(square(b[3] - b[0]) + square(b[4] - b[1]) + square(b[5] - b[2]));
        int vertices = mesh.vertices() + 2 * SIDES * edges.size();
        int faces = mesh.faces() + 2 * SIDES * edges.size();
        float[] positions = Arrays.copyOf(mesh.positions(), 3 * vertices);
        int[] corners = new int[3 * faces];
        for (int c = 0; c < 3 * mesh.faces(); c++) corners[c] = mesh.vertex(c / 3, c % 3);
        int vertex = mesh.vertices();
        int corner = 3 * mesh.faces();
        for (int[] edge : edges) {
            bar(mesh.positions(), edge, radius, positions, vertex);
            for (int i = 0; i < SIDES; i++) {
                int j = (i + 1) % SIDES;
                int[] side = {i, j, SIDES + j, i, SIDES + j, SIDES + i};
                for (int k : side) corners[corner++] = vertex + k;
            }
            vertex += 2 * SIDES;
        }
        int[] materials = new int[faces];
        Arrays.fill(materials, mesh.faces(), faces, 1);
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(corners)
                .faceMaterials(materials)
                .materials(List.of(material("surface", .8f), material("edges", .02f)))
                .build();
    }

    private static Material material(String name, float grey) {
        return new Material(name, List.of(new Material.Parameter("Kd", grey, grey, grey)), List.of());
    }

    /** The corners of a prism along an edge. */
    private static void bar(float[] from, int[] edge, double radius, float[] to, int vertex) {
        double[] along = new double[3];
        for (int k = 0; k < 3; k++) along[k] = (double) from[3 * edge[1] + k] - from[3 * edge[0] + k];
        int least = 0;
        for (int k = 1; k < 3; k++) if (Math.abs(along[k]) < Math.abs(along[least])) least = k;
        double[] axis = new double[3];
        axis[least] = 1;
        double[] side = unit(Reduction.cross(along, axis));
        double[] up = unit(Reduction.cross(along, side));
        for (int i = 0; i < 2 * SIDES; i++) {
            double angle = 2 * Math.PI * (i % SIDES) / SIDES;
            double c = radius * StrictMath.cos(angle);
            double s = radius * StrictMath.sin(angle);
            for (int k = 0; k < 3; k++)
                to[3 * (vertex + i) + k] = (float) (from[3 * edge[i / SIDES] + k] + c * side[k] + s * up[k]);
        }
    }

    private static double[] unit(double[] a) {
        double length = Math.sqrt(square(a[0]) + square(a[1]) + square(a[2]));
        return length > 0 ? new double[] {a[0] / length, a[1] / length, a[2] / length} : a;
    }

    private static double square(double x) {
        return x * x;
    }
}
