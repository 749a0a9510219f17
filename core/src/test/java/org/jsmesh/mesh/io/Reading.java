package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/** Short ways to read texts and to say what came out. */
final class Reading {
    private Reading() {}

    static ModelFile read(String name, String... lines) throws IOException {
        return ModelReader.read(name, bytes(lines), ResourceResolver.NONE);
    }

    static byte[] bytes(String... lines) {
        return (String.join("\n", lines) + "\n").getBytes(StandardCharsets.UTF_8);
    }

    static ModelFormatException refusal(String name, String... lines) {
        return refusal(name, bytes(lines));
    }

    static ModelFormatException refusal(String name, byte[] content) {
        return catchThrowableOfType(
                ModelFormatException.class, () -> ModelReader.read(name, content, ResourceResolver.NONE));
    }

    /** Each face as three positions such as {@code 0,0,0 1,0,0 0,1,0}. */
    static List<String> faces(Mesh mesh) {
        List<String> faces = new ArrayList<>();
        for (int f = 0; f < mesh.faces(); f++) {
            List<String> corners = new ArrayList<>();
            for (int i = 0; i < 3; i++) {
                int p = 3 * mesh.vertex(f, i);
                float[] xyz = mesh.positions();
                corners.add(FloatText.plain(xyz[p])
                        + ','
                        + FloatText.plain(xyz[p + 1])
                        + ','
                        + FloatText.plain(xyz[p + 2]));
            }
            faces.add(String.join(" ", corners));
        }
        return faces;
    }

    /** Vertex ids of all corners. */
    static int[] corners(Mesh mesh) {
        int[] ids = new int[3 * mesh.faces()];
        for (int i = 0; i < ids.length; i++) ids[i] = mesh.vertex(i / 3, i % 3);
        return ids;
    }

    /** The values of a channel at a corner, or null where it is absent. */
    static float[] at(Mesh mesh, Channel.Semantic semantic, int face, int corner) {
        Channel channel = mesh.channel(semantic);
        int wedge = mesh.faceWedges()[3 * face + corner];
        if (channel.isAbsent(wedge)) return null;
        float[] values = new float[channel.components()];
        for (int i = 0; i < values.length; i++) values[i] = channel.number(wedge, i);
        return values;
    }
}
