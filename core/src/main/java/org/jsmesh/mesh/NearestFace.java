package org.jsmesh.mesh;

/**
 * Finds, for a face that has no equal, the most similar one of some faces of another mesh, and names the first value in
 * which the two differ.
 */
final class NearestFace {
    private final Mesh original;
    private final Mesh other;
    private final CornerLayout layout;
    private final TupleTable corners;
    private final int[] originalIds;
    private final int[] otherIds;

    /** @param corners a table that holds the tuples of both meshes */
    NearestFace(Mesh original, Mesh other, CornerLayout layout, TupleTable corners) {
        this.original = original;
        this.other = other;
        this.layout = layout;
        this.corners = corners;
        originalIds = layout.intern(original, corners);
        otherIds = layout.intern(other, corners);
    }

    /**
     * @param face of the original
     * @param candidates faces of the other mesh
     */
    String describe(int face, int[] candidates) {
        int best = -1;
        int bestRotation = 0;
        int bestEqual = 0;
        double bestDistance = 0;
        for (int candidate : candidates) {
            for (int rotation = 0; rotation < 3; rotation++) {
                int equal = equalWords(face, candidate, rotation);
                double distance = distance(face, candidate, rotation);
                if (best < 0 || equal > bestEqual || (equal == bestEqual && distance < bestDistance)) {
                    best = candidate;
                    bestRotation = rotation;
                    bestEqual = equal;
                    bestDistance = distance;
                }
            }
        }
        String name = "face " + face + " of the original (vertices " + original.vertex(face, 0) + " "
                + original.vertex(face, 1) + " " + original.vertex(face, 2) + ")";
        if (best < 0) return name + ", " + MeshComparison.face(original, face) + ", is missing";
        return name + " differs: " + firstDifference(face, best, bestRotation);
    }

    private String firstDifference(int face, int candidate, int rotation) {
        for (int corner = 0; corner < 3; corner++) {
            int a = originalIds[original.faceWedges()[3 * face + corner]];
            int b = otherIds[other.faceWedges()[3 * candidate + (corner + rotation) % 3]];
            if (a == b) continue;
            for (int word = 0; word < layout.words(); word++) {
                if (corners.word(a, word) == corners.word(b, word)) continue;
                return "corner " + corner + " (vertex " + original.vertex(face, corner) + ") "
                        + value(word, corners.word(a, word), corners.word(b, word));
            }
        }
        return MaterialDifference.describe(material(original, face), material(other, candidate));
    }

    private String value(int word, int expected, int actual) {
        if (layout.isPresence(word)) {
            String what = layout.name(word).substring("presence of ".length());
            return expected == 0
                    ? "has a " + what + ", in the original none"
                    : "has no " + what + ", in the original one";
        }
        if (!layout.isFloat(word)) return layout.name(word) + " is " + actual + ", in the original " + expected;
        String how = (expected ^ actual) == 1 ? "differs in its last bit: " : "differs: ";
        return layout.name(word) + " " + how + bits(actual) + ", in the original " + bits(expected);
    }

    private static String bits(int raw) {
        String hex = Integer.toHexString(raw);
        return "0x" + "0".repeat(8 - hex.length()) + hex + " (" + Float.intBitsToFloat(raw) + ")";
    }

    private static Material material(Mesh mesh, int face) {
        int id = mesh.faceMaterials()[face];
        return id < 0 ? null : mesh.materials().get(id);
    }

    private int equalWords(int face, int candidate, int rotation) {
        int equal = 0;
        for (int corner = 0; corner < 3; corner++) {
            int a = originalIds[original.faceWedges()[3 * face + corner]];
            int b = otherIds[other.faceWedges()[3 * candidate + (corner + rotation) % 3]];
            if (a == b) equal += layout.words();
            else
                for (int word = 0; word < layout.words(); word++)
                    if (corners.word(a, word) == corners.word(b, word)) equal++;
        }
        return equal;
    }

    private double distance(int face, int candidate, int rotation) {
        double sum = 0;
        for (int corner = 0; corner < 3; corner++) {
            int a = 3 * original.vertex(face, corner);
            int b = 3 * other.vertex(candidate, (corner + rotation) % 3);
            for (int axis = 0; axis < 3; axis++)
                sum += Math.abs((double) original.positions()[a + axis] - other.positions()[b + axis]);
        }
        return sum;
    }
}
