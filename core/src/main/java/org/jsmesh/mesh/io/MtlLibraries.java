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
    private final Companions companions;
    private final List<Note> notes;
    private final String usual;
    private final Map<String, Material> materials = new HashMap<>();
    /** Folder of the library that defines a material. */
    private final Map<String, String> folders = new HashMap<>();

    private final Set<String> loaded = new LinkedHashSet<>();
    private final Set<String> absent = new HashSet<>();
    private final Set<String> missing = new LinkedHashSet<>();

    /** @param model name of the OBJ file, whose library usually has the same */
    MtlLibraries(String model, Companions companions, List<Note> notes) {
        this.companions = companions;
        this.notes = notes;
        usual = FileNames.stem(model) + ".mtl";
    }

    /** One file, whose name may hold blanks, or several separated by blanks; perhaps in quotes. */
    void load(String names) throws IOException {
        String name = FileNames.unquoted(names);
        if (name.isEmpty() || find(name)) return;
        for (String part : split(names)) {
            if (!find(part)) missing.add(part);
        }
    }

    /**
     * Blanks separate names, but a part without the extension belongs to the name that follows it: {@code my house.mtl
     * garden.mtl}. A comment may follow.
     */
    private static List<String> split(String names) {
        List<String> list = new ArrayList<>();
        StringBuilder name = new StringBuilder();
        for (String part : names.split("[ \t]+")) {
            if (part.startsWith("#") && !list.isEmpty() && name.length() == 0) break;
            if (name.length() > 0) name.append(' ');
            name.append(part);
            String whole = FileNames.unquoted(name.toString());
            if (whole.regionMatches(true, whole.length() - 4, ".mtl", 0, 4)) {
                list.add(whole);
                name.setLength(0);
            }
        }
        if (name.length() > 0) list.add(FileNames.unquoted(name.toString()));
        return list;
    }

    private boolean find(String name) throws IOException {
        if (loaded.contains(name)) return true;
        if (absent.contains(name)) return false;
        Optional<Resource> library = companions.find(name);
        if (library.isEmpty()) {
            absent.add(name);
            return false;
        }
        loaded.add(name);
        Map<String, Material> own = new HashMap<>();
        new MtlReader(name, library.get().content(), own, notes).read();
        String folder = CompanionPaths.folder(library.get().path());
        own.forEach((material, definition) -> {
            materials.put(material, definition);
            folders.put(material, folder);
        });
        return true;
    }

    /**
     * Definitions of the materials that faces name. Undefined materials have a name only, and are reported. Where none
     * of the libraries is there, the one with the model's name is taken.
     */
    List<Material> definitions(List<String> names) throws IOException {
        if (!missing.isEmpty() && loaded.isEmpty() && find(usual)) {
            String text = "Material libraries not found: " + Notes.names(missing) + ". " + Notes.shown(usual)
                    + " is read in their place.";
            notes.add(Notes.of(Note.Kind.CHANGED, text, missing).asWarning());
        } else if (!missing.isEmpty()) {
            notes.add(Notes.missing("Material libraries", "file", missing));
        }
        List<Material> list = new ArrayList<>();
        List<String> undefined = new ArrayList<>();
        for (String name : names) {
            Material material = materials.get(name);
            int comment = name.indexOf(" #");
            if (material == null && comment > 0)
                material = materials.get(name.substring(0, comment).trim());
            if (material == null) undefined.add(name);
            list.add(material == null ? Material.named(name) : located(material));
        }
        if (!undefined.isEmpty())
            notes.add(Notes.of(
                    Note.Kind.REPAIRED,
                    "Materials without a definition, their names kept: " + Notes.names(undefined) + ".",
                    undefined));
        return list;
    }

    /** The material with the paths of its textures as they are from the model's folder. */
    private Material located(Material material) throws IOException {
        String folder = folders.get(material.name());
        List<Material.TextureReference> textures = new ArrayList<>();
        for (Material.TextureReference t : material.textures())
            textures.add(new Material.TextureReference(t.key(), companions.pathFrom(folder, t.path())));
        return new Material(material.name(), material.parameters(), textures, material.gltf());
    }
}
