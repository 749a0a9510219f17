package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;

/**
 * Writes lines {@code o}, {@code g} and {@code s} before those faces of an OBJ file where something about them changes.
 */
final class ObjGroupLines {
    private static final Set<String> HELD = Set.of(FaceChannel.OBJECT, FaceChannel.GROUP, FaceChannel.SMOOTHING);

    private static final int KEY = 5;

    private final FaceChannel smoothing;
    private final Labels objects;
    private final Labels groups;
    private long smooth = -1;

    /** @param notes takes what OBJ does not hold of the attributes of faces */
    ObjGroupLines(Mesh mesh, List<String> notes) {
        List<String> changed = new ArrayList<>();
        objects = new Labels("o", mesh.faceChannel(FaceChannel.OBJECT), changed);
        groups = new Labels("g", mesh.faceChannel(FaceChannel.GROUP), changed);
        FaceChannel given = mesh.faceChannel(FaceChannel.SMOOTHING);
        smoothing = isHeld(given) ? given : null;
        List<String> left = new ArrayList<>();
        for (FaceChannel c : mesh.faceChannels())
            if (!HELD.contains(c.name())
                    || c == given && smoothing == null
                    || !c.name().equals(FaceChannel.SMOOTHING) && c.labels().isEmpty()) left.add(c.name());
        if (!left.isEmpty()) notes.add("OBJ does not hold these attributes of faces: " + Notes.names(left) + ".");
        if (!changed.isEmpty())
            notes.add("Groups and objects written under other names: " + Notes.names(changed) + ".");
    }

    private static boolean isHeld(FaceChannel smoothing) {
        return smoothing != null
                && smoothing.components() == 1
                && !smoothing.type().isFloat();
    }

    /**
     * The order in which to write the faces. Those without a material come first, because OBJ cannot take a material
     * back. Where there are groups, faces that have the same follow each other: a mesh need not have them in the order
     * of a file.
     */
    int[] order(Mesh mesh) {
        TupleIndex kinds = new TupleIndex(KEY);
        int[] kindOf = new int[mesh.faces()];
        int[] key = new int[KEY];
        boolean grouped = objects.channel != null || groups.channel != null || smoothing != null;
        for (int f = 0; f < kindOf.length; f++) {
            int material = mesh.faceMaterials()[f];
            key[0] = material < 0 ? 0 : 1;
            key[1] = objects.number(f);
            key[2] = groups.number(f);
            key[3] = grouped ? material : 0;
            key[4] = smoothing == null ? 0 : smoothing.values()[f];
            kindOf[f] = kinds.intern(key, 0);
        }
        int[] starts = starts(kinds, kindOf);
        int[] order = new int[kindOf.length];
        for (int f = 0; f < order.length; f++) order[starts[kindOf[f]]++] = f;
        return order;
    }

    /** Where the faces of each kind start, kinds sorted by their numbers. */
    private static int[] starts(TupleIndex kinds, int[] kindOf) {
        List<Integer> sorted = new ArrayList<>();
        for (int kind = 0; kind < kinds.size(); kind++) sorted.add(kind);
        Comparator<Integer> byKey = Comparator.comparingInt(kind -> kinds.value(kind, 0));
        for (int i = 1; i < KEY; i++) {
            int column = i;
            byKey = byKey.thenComparingInt(kind -> kinds.value(kind, column));
        }
        sorted.sort(byKey);
        int[] counts = new int[kinds.size()];
        for (int kind : kindOf) counts[kind]++;
        int[] starts = new int[kinds.size()];
        int start = 0;
        for (int kind : sorted) {
            starts[kind] = start;
            start += counts[kind];
        }
        return starts;
    }

    /** Writes what is new of a face. */
    void before(int face, TextOutput out) throws IOException {
        objects.before(face, out);
        groups.before(face, out);
        if (smoothing == null) return;
        long group = (long) smoothing.exact(face, 0);
        if (group == smooth) return;
        smooth = group;
        out.text("s ").text(group == 0 ? "off" : Long.toString(group)).line();
    }

    private static final class Labels {
        private final String keyword;
        private final FaceChannel channel; // or null
        private final List<String> names = new ArrayList<>();
        private String current = "";

        Labels(String keyword, FaceChannel given, List<String> changed) {
            this.keyword = keyword;
            channel = given == null || given.labels().isEmpty() ? null : given;
            if (channel == null) return;
            Map<String, String> taken = new HashMap<>();
            for (String label : new LinkedHashSet<>(channel.labels())) {
                String clean = clean(label);
                String name = clean;
                for (int n = 2; taken.containsKey(name); n++) name = clean + '-' + n;
                taken.put(name, label);
                if (!name.equals(label)) changed.add(label + " as " + name);
            }
            Map<String, String> written = new HashMap<>();
            taken.forEach((name, label) -> written.put(label, name));
            for (String label : channel.labels()) names.add(written.get(label));
        }

        /** A label as the rest of a line; the empty one stays. */
        private static String clean(String label) {
            StringBuilder clean = new StringBuilder();
            for (int i = 0; i < label.length(); i++) clean.append(label.charAt(i) < ' ' ? '_' : label.charAt(i));
            return clean.toString().trim();
        }

        int number(int face) {
            return channel == null ? 0 : channel.values()[face];
        }

        void before(int face, TextOutput out) throws IOException {
            if (channel == null) return;
            String name = names.get(channel.values()[face]);
            if (name.equals(current)) return;
            current = name;
            out.text(keyword).text(name.isEmpty() ? "" : " ").text(name).line();
        }
    }
}
