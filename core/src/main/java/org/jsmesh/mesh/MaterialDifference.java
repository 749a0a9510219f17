package org.jsmesh.mesh;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** Names the first thing in which two materials differ. */
final class MaterialDifference {
    /** A key with its meaning, in words and in bits. */
    private record Entry(String key, String words, String bits) {}

    private MaterialDifference() {}

    /**
     * @param original or null for a face without material, likewise {@code other}; not equal to each other
     * @return for instance {@code material "wood": Kd is 1.0 0.0 0.0, in the original 0.5 0.0 0.0}
     */
    static String describe(Material original, Material other) {
        if (original == null || other == null || !original.name().equals(other.name()))
            return "material is " + name(other) + ", in the original " + name(original);
        List<Entry> expected = entries(original);
        List<Entry> actual = entries(other);
        int i = 0;
        while (i < expected.size() && i < actual.size() && expected.get(i).equals(actual.get(i))) i++;
        return "material " + name(original) + ": " + difference(expected, actual, i);
    }

    private static String difference(List<Entry> expected, List<Entry> actual, int at) {
        if (at == expected.size()) return "has " + shown(actual.get(at)) + ", in the original nothing there";
        if (at == actual.size()) return "lacks " + shown(expected.get(at)) + " of the original";
        Entry e = expected.get(at);
        Entry a = actual.get(at);
        if (!e.key.equals(a.key)) return "has " + shown(a) + ", in the original there is " + shown(e);
        boolean alike = e.words.equals(a.words);
        return e.key + " is " + (alike ? a.bits : a.words) + ", in the original " + (alike ? e.bits : e.words);
    }

    private static String shown(Entry e) {
        return e.key + " " + e.words;
    }

    private static String name(Material m) {
        return m == null ? "none" : '"' + m.name() + '"';
    }

    /** In their order, which counts. */
    private static List<Entry> entries(Material m) {
        List<Entry> entries = new ArrayList<>();
        for (Material.Parameter p : m.parameters()) {
            StringBuilder words = new StringBuilder();
            StringBuilder bits = new StringBuilder();
            for (float value : p.values()) {
                words.append(words.length() == 0 ? "" : " ").append(value);
                bits.append(bits.length() == 0 ? "0x" : " 0x")
                        .append(Integer.toHexString(Float.floatToRawIntBits(value)));
            }
            entries.add(new Entry(p.key(), words.toString(), bits.toString()));
        }
        for (Material.TextureReference t : m.textures())
            entries.add(new Entry(t.key(), '"' + t.path() + '"', Objects.toString(t.path())));
        if (m.isGltf()) entries.add(new Entry("definition", m.gltf(), m.gltf()));
        return entries;
    }
}
