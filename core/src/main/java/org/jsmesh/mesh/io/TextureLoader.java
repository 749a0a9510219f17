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
    private final ResourceResolver resources;
    private final List<Note> notes;

    TextureLoader(ResourceResolver resources, List<Note> notes) {
        this.resources = resources;
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
            Optional<byte[]> bytes = resources.find(path);
            if (bytes.isPresent()) {
                textures.add(new Texture(path, bytes.get()));
            } else {
                missing.add(path);
            }
        }
        if (!missing.isEmpty())
            notes.add(
                    Notes.dropped("Textures not found, their references kept: " + Notes.names(missing) + ".", missing));
        return textures;
    }
}
