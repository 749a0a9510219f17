package org.jsmesh.files.gltf.read;

import java.util.Collection;
import java.util.stream.Collectors;
import org.jsmesh.mesh.Note;

/** Words of notes, and names from a file as they fit there. */
public final class NoteText {
    private static final int MOST = 8;
    private static final int LONGEST = 40;

    private NoteText() {}

    /** One that counts and lists names; the first is the example. */
    static Note note(Note.Kind kind, String what, Collection<String> names) {
        String first = shown(names.iterator().next());
        return new Note(kind, what + ": " + shown(names) + ".", names.size(), first);
    }

    static String count(int n, String what) {
        return n + " " + what + (n == 1 ? "" : "s");
    }

    /** {@return a list of names, shortened when there are many or long ones} */
    public static String shown(Collection<String> names) {
        String list = names.stream().limit(MOST).map(NoteText::shown).collect(Collectors.joining(", "));
        return names.size() > MOST ? list + " and " + (names.size() - MOST) + " more" : list;
    }

    private static String shown(String name) {
        String start = name.length() > LONGEST ? name.substring(0, LONGEST) + "…" : name;
        return start.replaceAll("\\p{Cntrl}", "?");
    }
}
