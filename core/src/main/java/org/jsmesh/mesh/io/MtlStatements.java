package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.List;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.mesh.Material;

/**
 * Writes the statements of one material in the order of its parameters. A texture comes at the first of its options, or
 * after all parameters.
 */
final class MtlStatements {
    /** Stands before a statement that follows from others. */
    static final String DERIVED = "# derived, for other programs:";

    private final TextOutput out;
    private final Material material;
    private final TextureFiles files;
    private final List<String> dropped;
    private int texturesWritten;

    /** @param dropped takes what MTL cannot say */
    MtlStatements(TextOutput out, Material material, TextureFiles files, List<String> dropped) {
        this.out = out;
        this.material = material;
        this.files = files;
        this.dropped = dropped;
    }

    void write() throws IOException {
        List<Material.Parameter> parameters = material.parameters();
        for (int i = 0; i < parameters.size(); i++) {
            Material.Parameter p = parameters.get(i);
            int texture = textureOfOption(p);
            if (texture >= 0) {
                while (texturesWritten < texture) texture(List.of());
                int end = i + 1;
                while (end < parameters.size()
                        && isOption(parameters.get(end), material.textures().get(texture))) end++;
                texture(parameters.subList(i, end));
                i = end - 1;
            } else if (isLine(p.key()) && !p.key().startsWith("newmtl")) {
                out.text(p.key()).numbers(p.values(), 0, p.values().length).line();
            } else {
                dropped.add(p.key());
            }
        }
        while (texturesWritten < material.textures().size()) texture(List.of());
        if (material.isGltf())
            out.text(MtlReader.GLTF).text(" ").text(material.gltf()).line();
        derivedColour();
        derivedTexture();
    }

    /** The next texture that an option belongs to, or −1. */
    private int textureOfOption(Material.Parameter p) {
        for (int t = texturesWritten; t < material.textures().size(); t++) {
            if (isOption(p, material.textures().get(t))) return t;
        }
        return -1;
    }

    private static boolean isOption(Material.Parameter p, Material.TextureReference texture) {
        return p.key().startsWith(texture.key() + " -") && isLine(p.key());
    }

    private void texture(List<Material.Parameter> options) throws IOException {
        Material.TextureReference texture = material.textures().get(texturesWritten++);
        String path = files.path(texture.path());
        if (!isLine(texture.key()) || !isLine(path) || !MtlReader.isTextureKey(texture.key())) {
            dropped.add(texture.key() + ' ' + texture.path());
            return;
        }
        out.text(texture.key());
        for (Material.Parameter p : options)
            out.text(p.key().substring(texture.key().length())).numbers(p.values(), 0, p.values().length);
        out.text(" ").text(path).line();
    }

    private void derivedColour() throws IOException {
        boolean foreign = material.isGltf() || material.parameter("rgb") != null;
        if (!foreign || material.parameter("Kd") != null) return;
        float[] colour = DisplayMaterial.of(material, false).plain();
        out.text(DERIVED).line().text("Kd").numbers(colour, 0, 3).line();
        if (colour[3] == 1 || material.parameter("d") != null) return;
        out.text(DERIVED).line().text("d").numbers(colour, 3, 1).line();
    }

    /** glTF counts v from the top of the image, MTL from its bottom. */
    private void derivedTexture() throws IOException {
        String path = null;
        for (Material.TextureReference t : material.textures()) {
            if (t.key().equals("map_Kd")) return;
            if (t.key().equals("baseColorTexture")) path = files.path(t.path());
        }
        if (path == null || !isLine(path)) return;
        out.text(DERIVED).line().text("map_Kd -s 1 -1 1 -o 0 1 0 ").text(path).line();
    }

    /** Whether a text survives as one line with blanks around it trimmed. */
    private static boolean isLine(String text) {
        if (text.isEmpty() || !text.equals(text.trim()) || text.startsWith("#") || text.endsWith("\\")) return false;
        return text.chars().noneMatch(c -> c < ' ');
    }
}
