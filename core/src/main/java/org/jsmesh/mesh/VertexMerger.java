package org.jsmesh.mesh;

import java.util.ArrayList;
import java.util.List;

/**
 * Makes vertices of bit-equal positions one, as files need that repeat a vertex for every normal, texture coordinate or part it has: without it every such seam would be a boundary,
 * where a simplification cannot go on and cracks open. What each had of its own stays in its wedges, so the identity of the mesh is the same.
 *
 * <p>Where it would do harm it is not done: surfaces that lie on each other, for instance the two sides of a leaf, would become edges of four faces. The mesh with the fewer fans
 * ({@link ManifoldCut}) is taken.
 */
public final class VertexMerger {
    private VertexMerger() {}

    /**
     * @param mesh as {@link MeshCleaner} leaves it
     * @param notes receives a sentence when vertices were merged
     * @return the same mesh when there is nothing to gain, else a clean one
     */
    public static Mesh merge(Mesh mesh, List<String> notes) {
        int[] firstEqual = firstEqual(mesh.positions());
        boolean[] used = new boolean[mesh.vertices()];
        for (int w : mesh.faceWedges()) used[mesh.wedgeVertices()[w]] = true;
        boolean[] met = new boolean[mesh.vertices()];
        int merged = 0;
        for (int v = 0; v < used.length; v++) {
            if (!used[v]) continue;
            if (met[firstEqual[v]]) merged++;
            met[firstEqual[v]] = true;
        }
        if (merged == 0) return mesh;
        int[] vertices = mesh.wedgeVertices().clone();
        for (int w = 0; w < vertices.length; w++) vertices[w] = firstEqual[vertices[w]];
        Mesh candidate = MeshBuilder.from(mesh).wedgeVertices(vertices).build();
        if (fans(candidate) >= fans(mesh)) return mesh;
        notes.add(merged + " vertices were merged with others at the same position");
        return MeshCleaner.clean(
                candidate,
                new ArrayList<>()); // drops the merged vertices, and merges wedges that only their vertices told apart
    }

    /** For each vertex the first with the same raw bits. */
    private static int[] firstEqual(float[] positions) {
        int[] bits = new int[positions.length];
        for (int i = 0; i < bits.length; i++) bits[i] = Float.floatToRawIntBits(positions[i]);
        TupleTable distinct = new TupleTable(3, positions.length / 3);
        int[] first = new int[positions.length / 3];
        int[] firstOfTuple = new int[positions.length / 3];
        for (int v = 0; v < first.length; v++) {
            int before = distinct.size();
            int tuple = distinct.intern(bits, 3 * v);
            if (tuple == before) firstOfTuple[tuple] = v;
            first[v] = firstOfTuple[tuple];
        }
        return first;
    }

    private static int fans(Mesh mesh) {
        CornerTable table = new ManifoldCut(mesh).table();
        int n = 0;
        for (int v = 0; v < table.vertices(); v++) if (table.cornerOf(v) >= 0) n++;
        return n;
    }
}
