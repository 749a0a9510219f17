package org.jsmesh.mesh.io;

import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/** The channels of a mesh that a simple format can hold: one of normals, one of texture coordinates, one of colours. */
final class HeldChannels {
    private final Mesh mesh;
    private final Channel normal;
    private final Channel texcoord;
    private final Channel colour;

    /** Looks for channels with a number of components that the format knows, and notes the others. */
    HeldChannels(Mesh mesh, int mostTexcoords, String format, List<String> notes) {
        this.mesh = mesh;
        normal = first(Channel.Semantic.NORMAL, 3, 3);
        texcoord = first(Channel.Semantic.TEXCOORD, 2, mostTexcoords);
        colour = first(Channel.Semantic.COLOUR, 3, 4);
        List<String> left = mesh.channels().stream()
                .filter(c -> c != normal && c != texcoord && c != colour)
                .map(Channel::name)
                .toList();
        if (!left.isEmpty()) notes.add(format + " does not hold these channels: " + Notes.names(left) + ".");
    }

    private Channel first(Channel.Semantic semantic, int least, int most) {
        for (Channel c : mesh.channels()) {
            boolean bytes = c.type() == Channel.Type.UINT8;
            if (c.semantic() == semantic
                    && c.components() >= least
                    && c.components() <= most
                    && (!bytes || semantic == Channel.Semantic.COLOUR)) {
                return c;
            }
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
        return normal != null || texcoord != null || colour != null;
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
