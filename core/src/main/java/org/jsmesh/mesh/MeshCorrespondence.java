package org.jsmesh.mesh;

import java.util.List;

/**
 * Finds which faces correspond in two meshes that are the same multiset of faces, and which wedges and vertices of one
 * mesh are alike.
 */
public final class MeshCorrespondence {
    private final int[] face;
    private final int[] rotation;

    /**
     * Finds the faces of another mesh that are those of the original.
     *
     * @param original the mesh whose faces and corners are asked for later
     * @param other a mesh with the same faces in any order
     * @throws IllegalArgumentException when the meshes are not the same
     */
    public MeshCorrespondence(Mesh original, Mesh other) {
        CornerLayout layout = new CornerLayout(original, other);
        TupleTable corners = new TupleTable(layout.words(), original.wedges());
        int[] originalIds = layout.intern(original, corners);
        int[] otherIds = layout.intern(other, corners);
        TupleTable keys = new TupleTable(3, original.faces());
        int[] first = new int[other.faces() + 1]; // face of the other mesh by key, 1-based; then by the face before
        int[] next = new int[other.faces() + 1];
        for (int f = other.faces() - 1; f >= 0; f--) {
            int key = keys.intern(key(other, f, otherIds), 0);
            next[f] = first[key];
            first[key] = f + 1;
        }
        face = new int[original.faces()];
        rotation = new int[original.faces()];
        for (int f = 0; f < face.length; f++) {
            int key = keys.intern(key(original, f, originalIds), 0);
            int g = take(original, f, other, first, next, key);
            if (g < 0) throw new IllegalArgumentException("face " + f + " is not in the other mesh");
            face[f] = g;
            rotation[f] = rotation(original, f, originalIds, other, g, otherIds);
        }
    }

    /** Removes a face with the same material and values from the list of a key. */
    private static int take(Mesh original, int f, Mesh other, int[] first, int[] next, int key) {
        if (key >= first.length) return -1;
        int before = -1;
        for (int at = first[key]; at > 0; at = next[at - 1]) {
            if (material(original, f).equals(material(other, at - 1))) {
                if (before < 0) first[key] = next[at - 1];
                else next[before] = next[at - 1];
                return at - 1;
            }
            before = at - 1;
        }
        return -1;
    }

    private static Object material(Mesh mesh, int face) {
        int material = mesh.faceMaterials()[face];
        Object value = material < 0 ? "" : mesh.materials().get(material);
        return mesh.faceChannels().isEmpty() ? value : List.of(value, FaceValues.key(mesh, face));
    }

    private static int[] key(Mesh mesh, int f, int[] ids) {
        int a = ids[mesh.faceWedges()[3 * f]];
        int b = ids[mesh.faceWedges()[3 * f + 1]];
        int c = ids[mesh.faceWedges()[3 * f + 2]];
        for (int i = 0; i < 2 && !(first(a, b, c, b, c, a) && first(a, b, c, c, a, b)); i++) {
            int front = a;
            a = b;
            b = c;
            c = front;
        }
        return new int[] {a, b, c};
    }

    private static boolean first(int a, int b, int c, int x, int y, int z) {
        return a != x ? a < x : b != y ? b < y : c <= z;
    }

    private static int rotation(Mesh original, int f, int[] originalIds, Mesh other, int g, int[] otherIds) {
        for (int r = 0; r < 3; r++) {
            boolean same = true;
            for (int j = 0; j < 3; j++) {
                int here = originalIds[original.faceWedges()[3 * f + j]];
                same &= here == otherIds[other.faceWedges()[3 * g + (j + r) % 3]];
            }
            if (same) return r;
        }
        throw new IllegalStateException("face " + f);
    }

    /**
     * Finds the face of the other mesh that corresponds to a face of the original.
     *
     * @param f face of the original
     * @return id of the face; no two faces of the original share one
     */
    public int face(int f) {
        return face[f];
    }

    /**
     * Tells how the corners of a face correspond: corner j of face f is corner (j + rotation) mod 3 of its face in the
     * other mesh.
     *
     * @param f face of the original
     * @return 0, 1 or 2
     */
    public int rotation(int f) {
        return rotation[f];
    }

    /**
     * Finds wedges that are alike.
     *
     * @param mesh any mesh
     * @return for each wedge the first one with the same position and attributes
     */
    public static int[] alikeWedges(Mesh mesh) {
        CornerLayout layout = new CornerLayout(mesh);
        return firsts(layout.intern(mesh, new TupleTable(layout.words(), mesh.wedges())));
    }

    /**
     * Finds vertices that are alike.
     *
     * @param mesh any mesh
     * @return for each vertex the first one with the same position
     */
    public static int[] alikeVertices(Mesh mesh) {
        boolean wide = mesh.isDouble();
        TupleTable table = new TupleTable(PositionBits.words(wide), mesh.vertices());
        int[] ids = new int[mesh.vertices()];
        int[] bits = new int[PositionBits.words(wide)];
        for (int v = 0; v < ids.length; v++) {
            PositionBits.put(bits, 0, mesh, v, wide);
            ids[v] = table.intern(bits, 0);
        }
        return firsts(ids);
    }

    private static int[] firsts(int[] ids) {
        int[] first = new int[ids.length];
        java.util.Arrays.fill(first, -1);
        int[] firsts = new int[ids.length];
        for (int i = 0; i < ids.length; i++) {
            if (first[ids[i]] < 0) first[ids[i]] = i;
            firsts[i] = first[ids[i]];
        }
        return firsts;
    }
}
