package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;

/**
 * The properties of a PLY file for attributes of the file's own meaning, by vertex and by face. One of several
 * components has a property for each, with a number behind its name. PLY holds numbers alone, no labels.
 */
final class PlyScalars {
    private static final int FLOAT_NAN = 0x7FC00000;
    private static final int DOUBLE_NAN = 0x7FF80000;
    private static final Set<String> OF_VERTICES =
            Set.of("x", "y", "z", "nx", "ny", "nz", "s", "t", "red", "green", "blue", "alpha");
    private static final Set<String> OF_FACES =
            Set.of("vertex_indices", "texcoord", "texnumber", "red", "green", "blue", "alpha");

    private final List<Channel> channels = new ArrayList<>();
    private final List<FaceChannel> faceChannels = new ArrayList<>();

    PlyScalars(Mesh mesh, List<String> notes) {
        Set<String> vertexNames = new HashSet<>(OF_VERTICES);
        for (Channel channel : mesh.channels()) {
            if (channel.semantic() != Channel.Semantic.CUSTOM) continue;
            // The others are named by HeldChannels
            if (isFit(names(channel.name(), channel.components()), vertexNames)) channels.add(channel);
        }
        noteApart(
                channels.stream()
                        .filter(c -> c.components() > 1)
                        .map(Channel::name)
                        .toList(),
                "",
                notes);
        List<String> unfit = new ArrayList<>();
        Set<String> faceNames = new HashSet<>(OF_FACES);
        for (FaceChannel channel : mesh.faceChannels()) {
            if (channel.labels().isEmpty() && isFit(names(channel.name(), channel.components()), faceNames))
                faceChannels.add(channel);
            else unfit.add(channel.name());
        }
        if (!unfit.isEmpty()) notes.add("PLY does not hold these attributes of faces: " + Notes.names(unfit) + ".");
        noteApart(
                faceChannels.stream()
                        .filter(c -> c.components() > 1)
                        .map(FaceChannel::name)
                        .toList(),
                " of faces",
                notes);
    }

    private static void noteApart(List<String> names, String of, List<String> notes) {
        if (!names.isEmpty())
            notes.add("PLY holds attributes" + of + " by single numbers, and each number of these is one by itself: "
                    + Notes.names(names) + ".");
    }

    private static List<String> names(String name, int components) {
        if (components == 1) return List.of(name);
        List<String> names = new ArrayList<>();
        for (int i = 0; i < components; i++) names.add(name + '_' + i);
        return names;
    }

    /** Whether names are words, and free. */
    private static boolean isFit(List<String> names, Set<String> taken) {
        for (String name : names) {
            boolean word = !name.isEmpty() && name.chars().allMatch(c -> c > ' ' && c < 0x7F);
            if (!word || taken.contains(name)) return false;
        }
        return taken.addAll(names);
    }

    /** Those of vertices. */
    List<Channel> channels() {
        return channels;
    }

    void vertexHeader(StringBuilder text) {
        for (Channel channel : channels) header(text, channel.name(), channel.components(), channel.type());
    }

    void faceHeader(StringBuilder text) {
        for (FaceChannel channel : faceChannels) header(text, channel.name(), channel.components(), channel.type());
    }

    private static void header(StringBuilder text, String name, int components, Channel.Type type) {
        for (String property : names(name, components))
            text.append("property ")
                    .append(PlyType.of(type).typeName())
                    .append(' ')
                    .append(property)
                    .append('\n');
    }

    void vertex(LittleEndianOutput out, int wedge) throws IOException {
        for (Channel channel : channels) {
            if (channel.isAbsent(wedge)) absent(out, channel);
            else values(out, channel.type(), channel.values(), wedge * channel.words(), channel.words());
        }
    }

    void face(LittleEndianOutput out, int face) throws IOException {
        for (FaceChannel channel : faceChannels)
            values(out, channel.type(), channel.values(), face * channel.words(), channel.words());
    }

    /** No number stands for none, where the type has one that is no number. */
    private static void absent(LittleEndianOutput out, Channel channel) throws IOException {
        int[] words = new int[channel.words()];
        if (channel.type() == Channel.Type.FLOAT32) Arrays.fill(words, FLOAT_NAN);
        for (int i = 1; channel.type() == Channel.Type.FLOAT64 && i < words.length; i += 2) words[i] = DOUBLE_NAN;
        values(out, channel.type(), words, 0, words.length);
    }

    static void values(LittleEndianOutput out, Channel.Type type, int[] values, int from, int count)
            throws IOException {
        for (int i = from; i < from + count; i++) {
            switch (PlyType.of(type).bytes()) {
                case 1 -> out.writeByte(values[i]);
                case 2 -> out.writeShort(values[i]);
                default -> out.writeInt(values[i]);
            }
        }
    }

    /** For whole numbers that are absent. */
    void noteAbsent(List<String> notes) {
        for (Channel channel : channels) {
            if (channel.hasAbsent() && !channel.type().isFloat())
                notes.add("PLY has no mark for absent attributes: where " + channel.name()
                        + " is absent zeros are written.");
        }
    }
}
