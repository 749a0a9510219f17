package org.jsmesh.encode;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.codec.entropy.TextModel;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
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

    /** Leaves room for the texts that are not of the mesh. */
    private static final int MOST_TEXTS_BYTES = TextModel.MOST_HISTORY - (1 << 16);

    private ArchiveLimits() {}

    /** @throws IllegalArgumentException that says what is too much, how much an archive holds, and what to do */
    static void check(Mesh mesh) {
        String cut = "Cut the model into parts";
        require(mesh.faces(), MOST_ELEMENTS, "faces", cut);
        require(mesh.vertices(), MOST_ELEMENTS, "vertices", cut);
        require(mesh.wedges(), MOST_ELEMENTS, "different corners", cut);
        require(mesh.channels().size(), MOST_CHANNELS, "attribute channels", "Leave some out");
        for (Channel c : mesh.channels()) text(c.name(), "a channel");
        require(mesh.faceChannels().size(), MOST_CHANNELS, "attributes of faces", "Leave some out");
        for (FaceChannel c : mesh.faceChannels()) {
            text(c.name(), "an attribute of faces");
            for (String label : c.labels()) text(label, c.name().equals("object") ? "an object" : "a group");
        }
        require(mesh.materials().size(), MOST_MATERIALS, "materials", "Use fewer, or cut the model into parts");
        for (Material m : mesh.materials()) material(m);
        require(
                mesh.textures().size(),
                MOST_TEXTURES,
                "images",
                "Join images to larger ones, or cut the model into parts");
        for (Texture t : mesh.textures()) text(t.path(), "an image");
        together(headerTexts(mesh), "names and definitions of materials", "Leave the extras of materials out");
        List<String> labels = new ArrayList<>();
        for (FaceChannel c : mesh.faceChannels()) {
            labels.add(c.name());
            labels.addAll(c.labels());
        }
        together(labels, "names of groups and objects", "Give them shorter names");
    }

    private static List<String> headerTexts(Mesh mesh) {
        List<String> texts = new ArrayList<>();
        for (Channel c : mesh.channels()) texts.add(c.name());
        for (Texture t : mesh.textures()) texts.add(t.path());
        for (Material m : mesh.materials()) {
            texts.add(m.name());
            texts.add(m.gltf());
            for (Material.Parameter p : m.parameters()) texts.add(p.key());
            for (Material.TextureReference t : m.textures()) {
                texts.add(t.key());
                texts.add(t.path());
            }
        }
        return texts;
    }

    private static void together(List<String> texts, String what, String remedy) {
        long bytes = 0;
        for (String text : texts) bytes += text.getBytes(StandardCharsets.UTF_8).length + TextModel.MATCH;
        if (bytes > MOST_TEXTS_BYTES)
            throw new IllegalArgumentException("the " + what + " have " + bytes
                    + " bytes together, an archive holds at most " + MOST_TEXTS_BYTES + ". " + remedy
                    + ", or cut the model into parts");
    }

    private static void material(Material m) {
        text(m.name(), "a material");
        String of = " of the material " + beginning(m.name());
        require(m.parameters().size(), MOST_PARAMETERS, "parameters" + of, "Leave some out");
        for (Material.Parameter p : m.parameters()) {
            text(p.key(), "a parameter");
            require(p.values().length, MOST_VALUES, "values of " + beginning(p.key()) + of, "Leave some out");
            for (float value : p.values()) {
                if (Float.isFinite(value)) continue;
                throw new IllegalArgumentException("a value of " + beginning(p.key()) + of + " is " + value
                        + ", an archive holds finite numbers alone. Correct it in the material");
            }
        }
        definition(m.gltf(), of);
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

    private static void definition(String gltf, String of) {
        if (gltf.length() <= TextModel.MOST_BYTES / 4) return;
        int bytes = gltf.getBytes(StandardCharsets.UTF_8).length;
        if (bytes > TextModel.MOST_BYTES)
            throw new IllegalArgumentException("the definition" + of + " has " + bytes
                    + " bytes, an archive holds at most " + TextModel.MOST_BYTES + ". Leave its extras out");
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
