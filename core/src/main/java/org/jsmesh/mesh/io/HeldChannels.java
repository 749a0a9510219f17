package org.jsmesh.mesh.io;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.display.LinearLight;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/**
 * The channels of a mesh that a simple format can hold: one of normals, one of texture coordinates, one of colours.
 * Programs take the colours of such formats as values of a screen, so linear light becomes levels of 8 bits.
 */
final class HeldChannels {
    private final Mesh mesh;
    private final Channel normal;
    private final Channel texcoord;
    private final Channel colour;
    private final List<Channel> others;

    /** Looks for channels with a number of components that the format knows, and notes the others. */
    HeldChannels(Mesh mesh, int mostTexcoords, String format, List<String> notes) {
        this(mesh, mostTexcoords, format, List.of(), notes);
    }

    /** @param others channels that the format holds, too */
    HeldChannels(Mesh mesh, int mostTexcoords, String format, List<Channel> others, List<String> notes) {
        this.mesh = mesh;
        this.others = others;
        normal = first(Channel.Semantic.NORMAL, 3, 3);
        texcoord = first(Channel.Semantic.TEXCOORD, 2, mostTexcoords);
        Channel given = first(Channel.Semantic.COLOUR, 3, 4);
        colour = given != null && given.isLinearLight() ? onScreen(given) : given;
        List<String> left = mesh.channels().stream()
                .filter(c -> c != normal && c != texcoord && c != given && !others.contains(c))
                .map(Channel::name)
                .toList();
        if (!left.isEmpty()) notes.add(format + " does not hold these channels: " + Notes.names(left) + ".");
        boolean same =
                given == colour || given.type() == colour.type() && Arrays.equals(given.values(), colour.values());
        if (!same)
            notes.add(format + " holds colours as a screen shows them: " + Notes.names(List.of(given.name()))
                    + ", in linear light, becomes levels of 8 bits.");
    }

    private static Channel onScreen(Channel light) {
        int n = light.components();
        int[] levels = new int[light.wedges() * n];
        BitSet absent = new BitSet();
        for (int w = 0; w < light.wedges(); w++) {
            absent.set(w, light.isAbsent(w));
            for (int k = 0; k < n && !light.isAbsent(w); k++) {
                float value = light.number(w, k);
                levels[w * n + k] =
                        k < 3 ? LinearLight.level(value) : Math.round(255 * Math.max(0, Math.min(1, value)));
            }
        }
        return new Channel(Channel.Semantic.COLOUR, "colour", n, Channel.Type.UINT8, levels, absent);
    }

    private Channel first(Channel.Semantic semantic, int least, int most) {
        for (Channel c : mesh.channels()) {
            boolean held = semantic == Channel.Semantic.COLOUR
                    ? c.type() != Channel.Type.FLOAT64
                    : c.type() == Channel.Type.FLOAT32;
            if (held && c.semantic() == semantic && c.components() >= least && c.components() <= most) return c;
        }
        return null;
    }

    /** Or null. */
    Channel normal() {
        return normal;
    }

    /** Or null. */
    Channel texcoord() {
        return texcoord;
    }

    /** Or null. */
    Channel colour() {
        return colour;
    }

    boolean any() {
        return normal != null || texcoord != null || colour != null || !others.isEmpty();
    }

    /** For formats that have no mark for it. */
    void noteAbsent(String format, List<String> notes) {
        for (Channel c : new Channel[] {normal, texcoord, colour}) {
            if (c != null && c.hasAbsent())
                notes.add(format + " has no mark for absent attributes: where " + c.name()
                        + " is absent zeros are written.");
        }
    }
}
