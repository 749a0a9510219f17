package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Note;

/** The material libraries that an OBJ file names. */
final class MtlLibraries {
    private final ResourceResolver resources;
    private final List<Note> notes;
    private final Map<String, Material> materials = new HashMap<>();
    private final Set<String> loaded = new LinkedHashSet<>();
    private final Set<String> absent = new HashSet<>();
    private final Set<String> missing = new LinkedHashSet<>();

    MtlLibraries(ResourceResolver resources, List<Note> notes) {
        this.resources = resources;
        this.notes = notes;
    }

    /** One file, whose name may hold blanks, or several separated by blanks. */
    void load(String names) throws IOException {
        if (names.isEmpty() || find(names)) return;
        for (String name : split(names)) {
            if (!find(name)) missing.add(name);
        }
    }

    /**
     * Blanks separate names, but a part without the extension belongs to the name that follows it: {@code my house.mtl
     * garden.mtl}.
     */
    private static List<String> split(String names) {
        List<String> list = new ArrayList<>();
        StringBuilder name = new StringBuilder();
        for (String part : names.split("[ \t]+")) {
            if (name.length() > 0) name.append(' ');
            name.append(part);
            if (part.regionMatches(true, part.length() - 4, ".mtl", 0, 4)) {
                list.add(name.toString());
                name.setLength(0);
            }
        }
        if (name.length() > 0) list.add(name.toString());
        return list;
    }

    private boolean find(String name) throws IOException {
        if (loaded.contains(name)) return true;
        if (absent.contains(name)) return false;
        Optional<byte[]> content = resources.find(name);
        if (content.isEmpty()) {
            absent.add(name);
            return false;
        }
        loaded.add(name);
        new MtlReader(name, content.get(), materials, notes).read();
        return true;
    }

    /** Definitions of the materials that faces name. Undefined materials have a name only, and are reported. */
    List<Material> definitions(List<String> names) {
        if (!missing.isEmpty())
            notes.add(Notes.dropped("Material libraries not found: " + Notes.names(missing) + ".", missing));
        List<Material> list = new ArrayList<>();
        List<String> undefined = new ArrayList<>();
        for (String name : names) {
            Material material = materials.get(name);
            if (material == null) undefined.add(name);
            list.add(material == null ? Material.named(name) : material);
        }
        if (!undefined.isEmpty())
            notes.add(Notes.of(
                    Note.Kind.REPAIRED,
                    "Materials without a definition, their names kept: " + Notes.names(undefined) + ".",
                    undefined));
        return list;
    }
}
