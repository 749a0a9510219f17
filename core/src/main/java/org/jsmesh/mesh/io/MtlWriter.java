package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jsmesh.mesh.Material;

/**
 * Writes a material library so that {@link MtlReader} gets the same definitions back. Colours and textures under keys of other formats are written once
 * more under those of MTL, for other programs, behind a comment that makes our reader skip them.
 */
final class MtlWriter {
    /** Stands before a statement that follows from others. */
    static final String DERIVED = "# derived, for other programs:";

    private final List<Material> materials;
    private final List<String> names = new ArrayList<>();
    private final List<String> notes;

    MtlWriter(List<Material> materials, List<String> notes) {
        this.materials = materials;
        this.notes = notes;
        Map<String, Material> taken = new HashMap<>();
        List<String> changed = new ArrayList<>();
        for (Material material : materials) {
            String clean = clean(material.name());
            String name = clean;
            for (int n = 2; taken.containsKey(name) && !taken.get(name).equals(material); n++) name = clean + '-' + n;
            taken.put(name, material);
            names.add(name);
            if (!name.equals(material.name())) changed.add(material.name() + " as " + name);
        }
        if (!changed.isEmpty()) notes.add("Materials written under other names: " + Notes.names(changed) + ".");
    }

    /** The name in the library of a material id. */
    String name(int material) {
        return names.get(material);
    }

    private static String clean(String name) {
        StringBuilder clean = new StringBuilder();
        for (int i = 0; i < name.length(); i++) clean.append(name.charAt(i) < ' ' ? '_' : name.charAt(i));
        String result = clean.toString().trim();
        if (result.endsWith("\\")) result = result.substring(0, result.length() - 1) + '_';
        return result.isEmpty() ? "material" : result;
    }

    void write(TextOutput out, TextureFiles textures) throws IOException {
        out.text("# written by jSM").line();
        Set<String> written = new HashSet<>();
        List<String> dropped = new ArrayList<>();
        for (int id = 0; id < names.size(); id++) {
            if (!written.add(names.get(id))) continue;
            out.line().text("newmtl ").text(names.get(id)).line();
            write(out, materials.get(id), textures, dropped);
        }
        if (!dropped.isEmpty()) notes.add("MTL does not hold these parameters: " + Notes.names(dropped) + ".");
    }

    private static void write(TextOutput out, Material material, TextureFiles textures, List<String> dropped)
            throws IOException {
        Set<String> textureKeys = new HashSet<>();
        material.textures().forEach(t -> textureKeys.add(t.key()));
        for (Material.Parameter p : material.parameters()) {
            if (isOption(p, textureKeys)) continue;
            if (!isLine(p.key()) || p.key().startsWith("newmtl")) {
                dropped.add(p.key());
                continue;
            }
            out.text(p.key()).numbers(p.values(), 0, p.values().length).line();
        }
        derivedColour(out, material);
        Set<String> optionsDone = new HashSet<>();
        for (Material.TextureReference t : material.textures()) {
            String path = textures.path(t.path());
            if (!isLine(t.key()) || !isLine(path) || !MtlReader.isTextureKey(t.key())) {
                dropped.add(t.key() + ' ' + t.path());
                continue;
            }
            out.text(t.key());
            if (optionsDone.add(t.key())) options(out, material, t.key());
            out.text(" ").text(path).line();
        }
        derivedTexture(out, material, textures);
    }

    private static boolean isOption(Material.Parameter p, Set<String> textureKeys) {
        int blank = p.key().indexOf(" -");
        return blank > 0 && textureKeys.contains(p.key().substring(0, blank));
    }

    private static void options(TextOutput out, Material material, String key) throws IOException {
        for (Material.Parameter p : material.parameters()) {
            if (!p.key().startsWith(key + " -") || !isLine(p.key())) continue;
            out.text(p.key().substring(key.length())).numbers(p.values(), 0, p.values().length);
        }
    }

    private static void derivedColour(TextOutput out, Material material) throws IOException {
        boolean foreign = material.parameter("baseColorFactor") != null || material.parameter("rgb") != null;
        if (!foreign || material.parameter("Kd") != null) return;
        float[] colour = material.displayColour();
        out.text(DERIVED).line().text("Kd").numbers(colour, 0, 3).line();
        if (colour[3] != 1 && material.parameter("d") == null)
            out.text(DERIVED).line().text("d").numbers(colour, 3, 1).line();
    }

    /** glTF counts v from the top of the image, MTL from its bottom. */
    private static void derivedTexture(TextOutput out, Material material, TextureFiles textures) throws IOException {
        String path = null;
        for (Material.TextureReference t : material.textures()) {
            if (t.key().equals("map_Kd")) return;
            if (t.key().equals("baseColorTexture")) path = textures.path(t.path());
        }
        if (path != null && isLine(path))
            out.text(DERIVED)
                    .line()
                    .text("map_Kd -s 1 -1 1 -o 0 1 0 ")
                    .text(path)
                    .line();
    }

    /** Whether a text survives as one line with blanks around it trimmed. */
    private static boolean isLine(String text) {
        if (text.isEmpty() || !text.equals(text.trim()) || text.startsWith("#") || text.endsWith("\\")) return false;
        return text.chars().noneMatch(c -> c < ' ');
    }
}
