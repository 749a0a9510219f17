package org.jsmesh.mesh;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Compares two meshes as multisets of oriented triangles with bit-equal corners and equal materials; see "the original"
 * in {@code docs/format.md}. Order and ids of faces, vertices and wedges do not count, nor does the first corner of a
 * face. Unlike {@link MeshIdentity} it can say what differs.
 */
public final class MeshComparison {
    private final Mesh original;
    private final Mesh other;
    private final CornerLayout layout;
    private final TupleTable corners;
    private final Map<Object, Integer> materials = new HashMap<>();
    private final int[] originalKeys;
    private final int[] otherKeys;

    private MeshComparison(Mesh original, Mesh other) {
        this.original = original;
        this.other = other;
        layout = new CornerLayout(original, other);
        corners = new TupleTable(layout.words(), original.wedges());
        originalKeys = keys(original);
        otherKeys = keys(other);
    }

    /**
     * The first difference as one sentence that names the face of the original (numbered from 0 in its order), the
     * corner and the value with its bits, or nothing when the meshes are the same. Textures are not compared.
     *
     * @param original the mesh that the sentence speaks of
     * @param other the mesh that is to be the same
     * @return the sentence, or nothing
     */
    public static Optional<String> firstDifference(Mesh original, Mesh other) {
        return new MeshComparison(original, other).difference();
    }

    /**
     * Four ints per face: the ids of its corners, rotated so that the smallest triple comes first, and its material
     * with the values of its face channels.
     */
    private int[] keys(Mesh mesh) {
        int[] wedgeIds = layout.intern(mesh, corners);
        int[] materialIds = new int[mesh.materials().size()];
        for (int m = 0; m < materialIds.length; m++)
            materialIds[m] = materials.computeIfAbsent(mesh.materials().get(m), x -> materials.size());
        int[] keys = new int[Sizes.of(4, mesh.faces(), "faces to compare")];
        for (int f = 0; f < mesh.faces(); f++) {
            int a = wedgeIds[mesh.faceWedges()[3 * f]];
            int b = wedgeIds[mesh.faceWedges()[3 * f + 1]];
            int c = wedgeIds[mesh.faceWedges()[3 * f + 2]];
            int rotations = 0;
            while (rotations < 2 && !isSmallestRotation(a, b, c)) {
                int first = a;
                a = b;
                b = c;
                c = first;
                rotations++;
            }
            keys[4 * f] = a;
            keys[4 * f + 1] = b;
            keys[4 * f + 2] = c;
            int material = mesh.faceMaterials()[f];
            keys[4 * f + 3] = material < 0 ? -1 : materialIds[material];
            if (!mesh.faceChannels().isEmpty()) {
                List<Object> both = List.of(keys[4 * f + 3], FaceValues.key(mesh, f));
                keys[4 * f + 3] = materials.computeIfAbsent(both, x -> materials.size());
            }
        }
        return keys;
    }

    private static boolean isSmallestRotation(int a, int b, int c) {
        return compare(a, b, c, b, c, a) <= 0 && compare(a, b, c, c, a, b) <= 0;
    }

    private static int compare(int a, int b, int c, int x, int y, int z) {
        if (a != x) return Integer.compare(a, x);
        return b != y ? Integer.compare(b, y) : Integer.compare(c, z);
    }

    private Optional<String> difference() {
        TupleTable faces = new TupleTable(4, original.faces());
        int[] surplus = new int[original.faces() + other.faces()];
        int[] originalIds = new int[original.faces()];
        int[] otherIds = new int[other.faces()];
        for (int f = 0; f < originalIds.length; f++) surplus[originalIds[f] = faces.intern(originalKeys, 4 * f)]++;
        for (int f = 0; f < otherIds.length; f++) surplus[otherIds[f] = faces.intern(otherKeys, 4 * f)]--;
        int missing = 0;
        int extra = 0;
        for (int s : surplus) {
            if (s > 0) missing += s;
            else extra -= s;
        }
        if (missing == 0 && extra == 0) return Optional.empty();
        String counts = " (" + missing + " of " + original.faces() + " faces missing, " + extra + " extra)";
        int[] candidates = unmatched(otherIds, surplus, -1);
        if (missing == 0) return Optional.of("the original has no face " + face(other, candidates[0]) + counts);
        int face = unmatched(originalIds, surplus, 1)[0];
        return Optional.of(new NearestFace(original, other, layout, corners).describe(face, candidates) + counts);
    }

    /** Faces that this mesh has more often than the other, in their order. */
    private static int[] unmatched(int[] ids, int[] surplus, int sign) {
        int[] left = surplus.clone();
        int[] found = new int[ids.length];
        int n = 0;
        for (int f = 0; f < ids.length; f++) {
            if (left[ids[f]] * sign <= 0) continue;
            left[ids[f]] -= sign;
            found[n++] = f;
        }
        return Arrays.copyOf(found, n);
    }

    static String face(Mesh mesh, int face) {
        StringBuilder s = new StringBuilder("with corners");
        for (int corner = 0; corner < 3; corner++) {
            int v = mesh.vertex(face, corner);
            s.append(corner == 0 ? " (" : ", (");
            for (int axis = 0; axis < 3; axis++) {
                s.append(axis == 0 ? "" : " ");
                if (mesh.isDouble()) s.append(mesh.coordinate(v, axis));
                else s.append(mesh.positions()[3 * v + axis]);
            }
            s.append(')');
        }
        return s.toString();
    }
}
