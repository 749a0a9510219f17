package org.jsmesh.files.gltf;

import java.util.Collection;
import java.util.stream.Collectors;
import org.jsmesh.mesh.Note;

/** Names from a file, fit for a message. */
final class GltfNames {
    private static final int MOST = 8;
    private static final int LONGEST = 40;

    private GltfNames() {}

    /** One that counts and lists names; the first is the example. */
    static Note note(Note.Kind kind, String what, Collection<String> names) {
        String first = shown(names.iterator().next());
        return new Note(kind, what + ": " + shown(names) + ".", names.size(), first);
    }

    static String count(int n, String what) {
        return n + " " + what + (n == 1 ? "" : "s");
    }

    static String shown(Collection<String> names) {
        String list = names.stream().limit(MOST).map(GltfNames::shown).collect(Collectors.joining(", "));
        return names.size() > MOST ? list + " and " + (names.size() - MOST) + " more" : list;
    }

    private static String shown(String name) {
        String start = name.length() > LONGEST ? name.substring(0, LONGEST) + "…" : name;
        return start.replaceAll("\\p{Cntrl}", "?");
    }
}
