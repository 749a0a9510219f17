package org.jsmesh.mesh;

import java.util.ArrayList;
import java.util.Arrays;
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
        int[] firstEqual = firstEqual(mesh.positions(), used);
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
    private static int[] firstEqual(float[] positions, boolean[] used) {
        int[] first = new int[used.length];
        int[] slots = new int[Integer.highestOneBit(Math.max(16, used.length)) * 4];
        Arrays.fill(slots, -1);
        int mask = slots.length - 1;
        for (int v = 0; v < first.length; v++) {
            first[v] = v;
            if (!used[v]) continue;
            int slot = hash(positions, v) & mask;
            while (slots[slot] >= 0 && !isSame(positions, v, slots[slot])) slot = slot + 1 & mask;
            if (slots[slot] < 0) slots[slot] = v;
            else first[v] = slots[slot];
        }
        return first;
    }

    private static int bits(float[] positions, int i) {
        return Float.floatToRawIntBits(positions[i]);
    }

    private static boolean isSame(float[] positions, int v, int w) {
        return bits(positions, 3 * v) == bits(positions, 3 * w)
                && bits(positions, 3 * v + 1) == bits(positions, 3 * w + 1)
                && bits(positions, 3 * v + 2) == bits(positions, 3 * w + 2);
    }

    private static int hash(float[] positions, int v) {
        int h = bits(positions, 3 * v) * 0x9E3779B1;
        h = (h ^ h >>> 15 ^ bits(positions, 3 * v + 1)) * 0x85EBCA6B;
        h = (h ^ h >>> 13 ^ bits(positions, 3 * v + 2)) * 0xC2B2AE35;
        return h ^ h >>> 16;
    }

    private static int fans(Mesh mesh) {
        CornerTable table = new ManifoldCut(mesh).table();
        int n = 0;
        for (int v = 0; v < table.vertices(); v++) if (table.cornerOf(v) >= 0) n++;
        return n;
    }
}
