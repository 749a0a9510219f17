package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;

/** Loads the images that materials name. Missing images are reported; references to them stay. */
final class TextureLoader {
    private final Companions companions;
    private final List<Note> notes;

    TextureLoader(ResourceResolver resources, List<Note> notes) {
        this(new Companions(resources), notes);
    }

    /** @param companions which also say what was found under another name */
    TextureLoader(Companions companions, List<Note> notes) {
        this.companions = companions;
        this.notes = notes;
    }

    List<Texture> load(List<Material> materials) throws IOException {
        Set<String> paths = new LinkedHashSet<>();
        for (Material material : materials) {
            for (Material.TextureReference reference : material.textures()) paths.add(reference.path());
        }
        List<Texture> textures = new ArrayList<>();
        List<String> missing = new ArrayList<>();
        for (String path : paths) {
            Optional<Resource> found = companions.find(path);
            if (found.isPresent()) {
                textures.add(new Texture(path, found.get().content()));
            } else {
                missing.add(path);
            }
        }
        companions.report(notes);
        if (!missing.isEmpty()) notes.add(Notes.missing("Textures", "image", missing));
        return textures;
    }
}
