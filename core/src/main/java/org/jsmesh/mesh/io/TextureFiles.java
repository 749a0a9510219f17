package org.jsmesh.mesh.io;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Texture;

/**
 * Writes the textures of a mesh beside a model file. Each keeps its path when the path stays within the folder. Else it
 * gets the path's last part, and references change accordingly.
 */
final class TextureFiles {
    private final Set<String> taken = new HashSet<>();
    private final Map<String, String> renamed = new HashMap<>();
    private final List<String> notes;

    /** @param reserved names of the model's own files */
    TextureFiles(Collection<String> reserved, List<String> notes) {
        reserved.forEach(this::isFree);
        this.notes = notes;
    }

    void write(Mesh mesh, ResourceSink sink) throws IOException {
        List<String> changed = new ArrayList<>();
        Set<String> done = new HashSet<>();
        for (Texture texture : mesh.textures()) {
            if (!done.add(texture.path())) continue;
            String name = FileNames.isSafe(texture.path()) ? texture.path() : FileNames.last(texture.path());
            String free = name;
            for (int n = 2; !isFree(free); n++) free = FileNames.numbered(name, n);
            if (!free.equals(texture.path())) {
                renamed.put(texture.path(), free);
                changed.add(texture.path() + " as " + free);
            }
            try (OutputStream out = sink.create(free)) {
                out.write(texture.bytes());
            }
        }
        if (!changed.isEmpty())
            notes.add("Textures written under other names, which every system takes: " + Notes.names(changed) + ".");
    }

    private boolean isFree(String name) {
        return taken.add(name.toLowerCase(Locale.ROOT));
    }

    /** The new path for a texture's path. */
    String path(String original) {
        return renamed.getOrDefault(original, original);
    }

    boolean areUnchanged() {
        return renamed.isEmpty();
    }
}
