package org.jsmesh.mesh;

import java.util.ArrayList;
import java.util.List;

/**
 * The words of a corner tuple for meshes to be compared. Three words hold position bits, or six where one of the meshes
 * is in double precision. For each channel that any of the meshes has, one word says whether the corner has the
 * attribute, and its raw values follow. As in {@link MeshIdentity}, channels are told apart by meaning, components,
 * type and order, not by name.
 */
final class CornerLayout {
    private static final String[] NORMAL = {"x", "y", "z", "w"};
    private static final String[] TEXCOORD = {"u", "v", "w", "q"};
    private static final String[] COLOUR = {"red", "green", "blue", "alpha"};

    private final List<Channel> kinds = new ArrayList<>();
    private final int positionWords;
    private int words;

    CornerLayout(Mesh... meshes) {
        boolean wide = false;
        for (Mesh mesh : meshes) wide |= mesh.isDouble();
        positionWords = PositionBits.words(wide);
        words = positionWords;
        for (Mesh mesh : meshes) {
            List<Channel> known = new ArrayList<>(kinds);
            for (Channel channel : mesh.channels()) {
                if (removeAlike(known, channel)) continue;
                kinds.add(channel);
                words += 1 + channel.words();
            }
        }
    }

    /** Ints per tuple. */
    int words() {
        return words;
    }

    /** The id of each wedge's tuple in the table. */
    int[] intern(Mesh mesh, TupleTable table) {
        List<Channel> channels = new ArrayList<>();
        for (int k = 0; k < kinds.size(); k++) channels.add(find(mesh, kinds, k));
        int[] ids = new int[mesh.wedges()];
        int[] tuple = new int[words];
        for (int wedge = 0; wedge < ids.length; wedge++) {
            int at = PositionBits.put(tuple, 0, mesh, mesh.wedgeVertices()[wedge], isWide());
            for (int k = 0; k < kinds.size(); k++) {
                Channel channel = channels.get(k);
                boolean present = channel != null && !channel.isAbsent(wedge);
                tuple[at++] = present ? 1 : 0;
                for (int c = 0; c < kinds.get(k).words(); c++) {
                    tuple[at++] = present ? channel.values()[wedge * channel.words() + c] : 0;
                }
            }
            ids[wedge] = table.intern(tuple, 0);
        }
        return ids;
    }

    private boolean isWide() {
        return positionWords > 3;
    }

    /** What a word is, for instance {@code position x} or {@code normal y}. */
    String name(int word) {
        if (word < positionWords) return "position " + NORMAL[isWide() ? word / 2 : word];
        int at = positionWords;
        for (Channel kind : kinds) {
            int within = word - at - 1;
            if (within < 0) return "presence of " + kind.name();
            if (within < kind.words())
                return kind.name() + " " + component(kind, within / kind.type().words());
            at += 1 + kind.words();
        }
        throw new IllegalArgumentException("word " + word + " of " + words);
    }

    /** The type of the number that the word belongs to; null when the word only says whether there is one. */
    Channel.Type type(int word) {
        if (word < positionWords) return isWide() ? Channel.Type.FLOAT64 : Channel.Type.FLOAT32;
        int at = positionWords;
        for (Channel kind : kinds) {
            if (word == at) return null;
            if (word <= at + kind.words()) return kind.type();
            at += 1 + kind.words();
        }
        throw new IllegalArgumentException("word " + word + " of " + words);
    }

    /** The first word of the number that the word belongs to. */
    int start(int word) {
        if (word < positionWords) return isWide() ? word & ~1 : word;
        int at = positionWords;
        for (Channel kind : kinds) {
            if (word <= at + kind.words()) {
                int size = kind.type().words();
                return word == at ? at : at + 1 + (word - at - 1) / size * size;
            }
            at += 1 + kind.words();
        }
        throw new IllegalArgumentException("word " + word + " of " + words);
    }

    private static String component(Channel kind, int index) {
        return switch (kind.semantic()) {
            case NORMAL -> NORMAL[index];
            case TEXCOORD -> TEXCOORD[index];
            case COLOUR -> COLOUR[index];
            case CUSTOM -> kind.components() == 1 ? "value" : "value " + index;
        };
    }

    private static boolean removeAlike(List<Channel> channels, Channel like) {
        for (Channel c : channels) {
            if (isAlike(c, like)) return channels.remove(c);
        }
        return false;
    }

    /**
     * The channel of a mesh for a kind. Among several with the same meaning, components and type, it is the one with
     * the same number.
     */
    private static Channel find(Mesh mesh, List<Channel> kinds, int kind) {
        int number = 0;
        for (int k = 0; k < kind; k++) if (isAlike(kinds.get(k), kinds.get(kind))) number++;
        for (Channel c : mesh.channels()) {
            if (isAlike(c, kinds.get(kind)) && number-- == 0) return c;
        }
        return null;
    }

    private static boolean isAlike(Channel a, Channel b) {
        return a.semantic() == b.semantic() && a.components() == b.components() && a.type() == b.type();
    }
}
