package org.jsmesh.mesh;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** The values of face channels, to compare those of two meshes. */
final class FaceValues {
    private FaceValues() {}

    /** All values of a face as one key: equal keys, equal values. Channels are told apart by name, not by order. */
    static Object key(Mesh mesh, int face) {
        if (mesh.faceChannels().isEmpty()) return List.of();
        List<FaceChannel> channels = new ArrayList<>(mesh.faceChannels());
        channels.sort(Comparator.comparing(FaceChannel::name));
        List<Object> key = new ArrayList<>();
        for (FaceChannel c : channels) {
            key.add(c.name());
            key.add(c.type());
            key.add(c.components());
            if (!c.labels().isEmpty()) key.add(c.label(face));
            else for (int k = 0; k < c.words(); k++) key.add(c.values()[c.words() * face + k]);
        }
        return key;
    }

    /** In words, the first channel in which two faces differ. */
    static String difference(Mesh original, int face, Mesh other, int candidate) {
        for (FaceChannel c : original.faceChannels()) {
            FaceChannel same = other.faceChannel(c.name());
            if (same == null) return "it has no " + c.name() + ", in the original one";
            String expected = text(c, face);
            String actual = text(same, candidate);
            if (!expected.equals(actual)) return c.name() + " is " + actual + ", in the original " + expected;
        }
        for (FaceChannel c : other.faceChannels())
            if (original.faceChannel(c.name()) == null) return "it has a " + c.name() + ", in the original none";
        return "an attribute of the face has another type";
    }

    private static String text(FaceChannel c, int face) {
        if (!c.labels().isEmpty()) return "'" + c.label(face) + "'";
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < c.components(); i++) {
            double value = c.exact(face, i);
            text.append(i == 0 ? "" : " ");
            if (c.type().isFloat()) text.append(value);
            else text.append((long) value);
        }
        return text.toString();
    }
}
