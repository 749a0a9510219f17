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
                return "corner " + corner + " (vertex " + original.vertex(face, corner) + ") " + value(word, a, b);
            }
        }
        Material expected = material(original, face);
        Material actual = material(other, candidate);
        if (expected != null ? expected.equals(actual) : actual == null)
            return FaceValues.difference(original, face, other, candidate);
        return MaterialDifference.describe(expected, actual);
    }

    /** In words, how the tuples of a corner differ in the number that a word belongs to. */
    private String value(int word, int a, int b) {
        Channel.Type type = layout.type(word);
        String name = layout.name(word);
        if (type == null) {
            String what = name.substring("presence of ".length());
            return corners.word(a, word) == 0
                    ? "has a " + what + ", in the original none"
                    : "has no " + what + ", in the original one";
        }
        int start = layout.start(word);
        int[] expected = new int[type.words()];
        int[] actual = new int[type.words()];
        int different = 0;
        for (int i = 0; i < expected.length; i++) {
            expected[i] = corners.word(a, start + i);
            actual[i] = corners.word(b, start + i);
            different |= i == 0 ? (expected[i] ^ actual[i]) & ~1 : expected[i] ^ actual[i];
        }
        if (!type.isFloat())
            return name + " is " + (long) type.number(actual, 0) + ", in the original "
                    + (long) type.number(expected, 0);
        String how = different == 0 ? "differs in its last bit: " : "differs: ";
        return name + " " + how + bits(type, actual) + ", in the original " + bits(type, expected);
    }

    private static String bits(Channel.Type type, int[] words) {
        StringBuilder hex = new StringBuilder("0x");
        for (int i = words.length - 1; i >= 0; i--) {
            String digits = Integer.toHexString(words[i]);
            hex.append("0".repeat(8 - digits.length())).append(digits);
        }
        return hex + " ("
                + (words.length == 1
                        ? Float.toString(Float.intBitsToFloat(words[0]))
                        : Double.toString(type.number(words, 0)))
                + ")";
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
            int a = original.vertex(face, corner);
            int b = other.vertex(candidate, (corner + rotation) % 3);
            for (int axis = 0; axis < 3; axis++)
                sum += Math.abs(original.coordinate(a, axis) - other.coordinate(b, axis));
        }
        return sum;
    }
}
