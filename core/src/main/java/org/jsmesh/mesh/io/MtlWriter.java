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
 * Writes a material library so that {@link MtlReader} gets the same definitions back. Colours and textures under keys
 * of other formats are also written under the keys of MTL, for other programs, behind a comment that makes our reader
 * skip them.
 */
final class MtlWriter {
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
            new MtlStatements(out, materials.get(id), textures, dropped).write();
        }
        if (!dropped.isEmpty()) notes.add("MTL does not hold these parameters: " + Notes.names(dropped) + ".");
    }
}
