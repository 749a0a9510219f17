package org.jsmesh.encode;

import java.nio.charset.StandardCharsets;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Texture;

/** Checks the limits of {@code docs/format.md} before the long work instead of at its end. */
final class ArchiveLimits {
    private static final int MOST_ELEMENTS = (1 << 28) - 1;
    private static final int MOST_CHANNELS = 64;
    private static final int MOST_MATERIALS = 1 << 20;
    private static final int MOST_TEXTURES = 1 << 12;
    private static final int MOST_PARAMETERS = 1 << 12;
    private static final int MOST_VALUES = 256;
    private static final int MOST_TEXT_BYTES = 1 << 12;

    private ArchiveLimits() {}

    /** @throws IllegalArgumentException that says what is too much, how much an archive holds, and what to do */
    static void check(Mesh mesh) {
        String cut = "Cut the model into parts";
        require(mesh.faces(), MOST_ELEMENTS, "faces", cut);
        require(mesh.vertices(), MOST_ELEMENTS, "vertices", cut);
        require(mesh.wedges(), MOST_ELEMENTS, "different corners", cut);
        require(mesh.channels().size(), MOST_CHANNELS, "attribute channels", "Leave some out");
        for (Channel c : mesh.channels()) text(c.name(), "a channel");
        require(mesh.materials().size(), MOST_MATERIALS, "materials", "Use fewer, or cut the model into parts");
        for (Material m : mesh.materials()) material(m);
        require(
                mesh.textures().size(),
                MOST_TEXTURES,
                "images",
                "Join images to larger ones, or cut the model into parts");
        for (Texture t : mesh.textures()) text(t.path(), "an image");
    }

    private static void material(Material m) {
        text(m.name(), "a material");
        String of = " of the material " + beginning(m.name());
        require(m.parameters().size(), MOST_PARAMETERS, "parameters" + of, "Leave some out");
        for (Material.Parameter p : m.parameters()) {
            text(p.key(), "a parameter");
            require(p.values().length, MOST_VALUES, "values of " + beginning(p.key()) + of, "Leave some out");
        }
        require(m.textures().size(), MOST_PARAMETERS, "images" + of, "Leave some out");
        for (Material.TextureReference t : m.textures()) {
            text(t.key(), "a parameter");
            text(t.path(), "an image");
        }
    }

    private static void require(int count, int most, String what, String remedy) {
        if (count > most)
            throw new IllegalArgumentException(
                    "there are " + count + " " + what + ", an archive holds at most " + most + ". " + remedy);
    }

    private static void text(String name, String what) {
        if (name.length() <= MOST_TEXT_BYTES / 4) return; // no character has more bytes
        int bytes = name.getBytes(StandardCharsets.UTF_8).length;
        if (bytes > MOST_TEXT_BYTES)
            throw new IllegalArgumentException("the name of " + what + " has " + bytes + " bytes (" + beginning(name)
                    + "), an archive holds at most " + MOST_TEXT_BYTES + ". Give it a shorter name");
    }

    private static String beginning(String name) {
        return '"' + (name.length() <= 40 ? name : name.substring(0, 40) + "…") + '"';
    }
}
