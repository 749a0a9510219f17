package org.jsmesh.mesh;

import java.util.ArrayList;
import java.util.List;

/**
 * Merges vertices of bit-equal positions. Files that repeat a vertex for every normal, texture coordinate or part need
 * this: otherwise every such seam would be a boundary, where a simplification cannot go on and cracks open. The
 * attributes of each stay in its wedges, so the identity of the mesh is the same.
 *
 * <p>Vertices are not merged where it would do harm: surfaces that lie on each other, for instance the two sides of a
 * leaf, would get edges of four faces. The mesh with the fewer fans ({@link ManifoldCut}) is taken.
 */
public final class VertexMerger {
    private VertexMerger() {}

    /**
     * @param mesh as {@link MeshCleaner} leaves it
     * @param notes receives how many vertices were merged
     * @return the same mesh when there is nothing to gain, else a clean one
     */
    public static Mesh merge(Mesh mesh, List<Note> notes) {
        boolean[] used = new boolean[mesh.vertices()];
        for (int w : mesh.faceWedges()) used[mesh.wedgeVertices()[w]] = true;
        int[] firstEqual = firstEqual(mesh, used);
        int merged = 0;
        int first = -1;
        for (int v = 0; v < used.length; v++) {
            if (firstEqual[v] == v) continue;
            if (merged++ == 0) first = v;
        }
        if (merged == 0) return mesh;
        int[] vertices = mesh.wedgeVertices().clone();
        for (int w = 0; w < vertices.length; w++) vertices[w] = firstEqual[vertices[w]];
        Mesh candidate = MeshBuilder.from(mesh).wedgeVertices(vertices).build();
        if (fans(candidate) >= fans(mesh)) return mesh;
        String what = merged == 1 ? "1 vertex merged with another" : merged + " vertices merged with others";
        notes.add(Note.repaired(what + " at the same position.", merged, "vertex " + first));
        return MeshCleaner.clean(
                candidate,
                new ArrayList<>()); // drops the merged vertices, and merges wedges that differed only by their vertices
    }

    /** For each vertex, the first used vertex with the same raw bits; for an unused vertex, itself. */
    private static int[] firstEqual(Mesh mesh, boolean[] used) {
        boolean wide = mesh.isDouble();
        int words = PositionBits.words(wide);
        TupleTable table = new TupleTable(words, used.length);
        int[] firstOf = new int[used.length];
        int[] first = new int[used.length];
        int[] bits = new int[words];
        for (int v = 0; v < first.length; v++) {
            first[v] = v;
            if (!used[v]) continue;
            PositionBits.put(bits, 0, mesh, v, wide);
            int known = table.size();
            int id = table.intern(bits, 0);
            if (id == known) firstOf[id] = v;
            else first[v] = firstOf[id];
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
