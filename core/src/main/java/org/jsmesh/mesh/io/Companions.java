package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jsmesh.mesh.Note;

/** The files that one model refers to, each looked for once. */
final class Companions {
    private final ResourceResolver resources;
    private final Map<String, Optional<Resource>> known = new HashMap<>();
    private final Set<String> renamed = new LinkedHashSet<>();

    Companions(ResourceResolver resources) {
        this.resources = resources;
    }

    /** Finds a file that becomes part of the model. */
    Optional<Resource> find(String path) throws IOException {
        Optional<Resource> found = locate(path);
        if (found.isPresent()
                && !CompanionPaths.normal(path).equals(found.get().path())
                && !path.equals(found.get().path()))
            renamed.add(path + " as " + found.get().path());
        return found;
    }

    /**
     * The path under which to look for a file that a material library names: first from the model's folder, then from
     * the library's, then without what may be a comment.
     *
     * @param folder of the library, empty when it is the model's
     */
    String pathFrom(String folder, String path) throws IOException {
        Optional<Resource> found = locate(path);
        if (found.isPresent() && CompanionPaths.isWhole(path, found.get().path())) return path;
        if (!folder.isEmpty()) {
            String below = CompanionPaths.normal(folder + '/' + path);
            Optional<Resource> besideLibrary = locate(below);
            if (besideLibrary.isPresent()
                    && CompanionPaths.isWhole(below, besideLibrary.get().path())) return below;
        }
        int comment = path.indexOf(" #");
        if (found.isPresent() || comment < 0) return path;
        String before = path.substring(0, comment).trim();
        String other = before.isEmpty() ? before : pathFrom(folder, before);
        return !other.isEmpty() && locate(other).isPresent() ? other : path;
    }

    private Optional<Resource> locate(String path) throws IOException {
        Optional<Resource> before = known.get(path);
        if (before != null) return before;
        Optional<Resource> found = resources.locate(path);
        known.put(path, found);
        return found;
    }

    /** Says which files have other names than the model gives. */
    void report(List<Note> notes) {
        if (!renamed.isEmpty())
            notes.add(Notes.of(
                    Note.Kind.REPAIRED, "Files found under another name: " + Notes.names(renamed) + ".", renamed));
    }
}
