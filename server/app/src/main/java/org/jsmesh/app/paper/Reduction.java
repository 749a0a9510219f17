package org.jsmesh.app.paper;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.collapse.Effort;
import org.jsmesh.collapse.QuadricSimplifier;
import org.jsmesh.collapse.SimplificationTarget;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshCleaner;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.VertexMerger;

/** A model with fewer faces, by the default simplifier. */
final class Reduction {
    private static final double DECIMALS = 1e6;

    private Reduction() {}

    /**
     * Positions and faces of a mesh, as many faces at most, where they can be removed. Vertices have the normals of the
     * whole surface there, as the paper's models have some: of its faces by area, with six decimals.
     */
    static Mesh to(Mesh mesh, int faces) {
        int[] corners = new int[3 * mesh.faces()];
        for (int c = 0; c < corners.length; c++) corners[c] = mesh.vertex(c / 3, c % 3);
        Mesh bare = clean(new MeshBuilder()
                .positions(mesh.positions())
                .faceWedges(corners)
                .build());
        CollapseMesh collapsing = new CollapseMesh(bare);
        QuadricSimplifier.simplify(collapsing, SimplificationTarget.ofFaces(faces), Effort.SOME, ProgressListener.NONE);
        int[] vertices = new int[bare.vertices()];
        Mesh reduced = live(collapsing, vertices);
        int[] normals = normals(bare);
        int[] kept = new int[3 * reduced.vertices()];
        for (int v = 0; v < reduced.vertices(); v++) System.arraycopy(normals, 3 * vertices[v], kept, 3 * v, 3);
        Channel channel = new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, kept, null);
        return MeshBuilder.from(reduced).channels(List.of(channel)).build();
    }

    /** Raw bits of the normal of each vertex. */
    private static int[] normals(Mesh mesh) {
        double[] sums = new double[3 * mesh.vertices()];
        for (int f = 0; f < mesh.faces(); f++) {
            double[] n = cross(edge(mesh, f, 1), edge(mesh, f, 2));
            for (int c = 0; c < 3; c++) for (int k = 0; k < 3; k++) sums[3 * mesh.vertex(f, c) + k] += n[k];
        }
        int[] bits = new int[sums.length];
        for (int at = 0; at < sums.length; at += 3) {
            double length = Math.sqrt(sums[at] * sums[at] + sums[at + 1] * sums[at + 1] + sums[at + 2] * sums[at + 2]);
            for (int k = 0; k < 3; k++)
                bits[at + k] = Float.floatToRawIntBits(
                        length > 0 ? (float) (Math.rint(sums[at + k] / length * DECIMALS) / DECIMALS) : 0);
        }
        return bits;
    }

    private static double[] edge(Mesh mesh, int face, int corner) {
        double[] edge = new double[3];
        for (int k = 0; k < 3; k++)
            edge[k] = mesh.coordinate(mesh.vertex(face, corner), k) - mesh.coordinate(mesh.vertex(face, 0), k);
        return edge;
    }

    static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /** As the encoder has it: without what no face uses, every position once. */
    static Mesh clean(Mesh mesh) {
        return VertexMerger.merge(MeshCleaner.clean(mesh, new ArrayList<>()), new ArrayList<>());
    }

    /**
     * Positions and faces that are left.
     *
     * @param vertices gets the vertex of the original of each vertex
     */
    static Mesh live(CollapseMesh mesh, int[] vertices) {
        int[] place = new int[mesh.original().vertices()];
        Arrays.fill(place, -1);
        float[] positions = new float[mesh.original().positions().length];
        int[] corners = new int[3 * mesh.original().faces()];
        int count = 0;
        int size = 0;
        for (int f = 0; f < mesh.original().faces(); f++) {
            if (!mesh.isLiveFace(f)) continue;
            for (int k = 0; k < 3; k++) {
                int v = mesh.vertexOf()[mesh.table().vertex(CornerTable.STRIDE * f + k)];
                if (place[v] < 0) {
                    System.arraycopy(mesh.original().positions(), 3 * v, positions, 3 * count, 3);
                    vertices[count] = v;
                    place[v] = count++;
                }
                corners[size++] = place[v];
            }
        }
        return new MeshBuilder()
                .positions(Arrays.copyOf(positions, 3 * count))
                .faceWedges(Arrays.copyOf(corners, size))
                .build();
    }
}
