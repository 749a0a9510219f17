package org.jsmesh.mesh.io.threemf;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jsmesh.mesh.Note;

/** What a package says and the mesh does not. */
final class PackageNotes {
    private static final int MOST_NAMES = 8;
    private static final int LONGEST_NAME = 100;

    /** More names than this are not kept in mind. */
    private static final int MOST_KEPT = 1000;

    final Set<String> elements = new LinkedHashSet<>();
    final Set<String> metadata = new LinkedHashSet<>();
    final Set<String> parts = new LinkedHashSet<>();
    final Set<String> textures = new LinkedHashSet<>();
    final Set<String> properties = new LinkedHashSet<>();
    String unit;
    int unused;
    int usedObjects;

    static void keep(Set<String> names, String name) {
        if (names.size() < MOST_KEPT) names.add(name);
    }

    /** Whether all coordinates are those of float32, in the words of the file. */
    boolean isFloat = true;

    void report(List<Note> notes) {
        if (unit != null)
            notes.add(Note.dropped("The unit (" + unit + ") is not kept; the numbers are as they were.", 1, unit));
        named(notes, Note.Kind.DROPPED, "Textures not found", textures, true);
        named(notes, Note.Kind.DROPPED, "Properties of triangles not kept", properties, true);
        named(notes, Note.Kind.DROPPED, "Metadata not kept", metadata, false);
        named(notes, Note.Kind.UNREAD, "Elements skipped", elements, false);
        named(notes, Note.Kind.UNREAD, "Parts of the package skipped", parts, false);
        if (unused > 0)
            notes.add(Note.dropped(
                    unused + (unused == 1 ? " object" : " objects") + " that no build item uses left out.",
                    unused,
                    ""));
    }

    private static void named(List<Note> notes, Note.Kind kind, String what, Set<String> names, boolean warning) {
        if (names.isEmpty()) return;
        List<String> shown =
                names.stream().limit(MOST_NAMES).map(PackageNotes::shown).toList();
        String more = names.size() > MOST_NAMES ? " and " + (names.size() - MOST_NAMES) + " more" : "";
        Note note =
                new Note(kind, what + ": " + String.join(", ", shown) + more + ".", names.size(), shown.get(0), false);
        notes.add(warning ? note.asWarning() : note);
    }

    /** A name from a file, fit for a message. */
    static String shown(String name) {
        String cut = name.length() > LONGEST_NAME ? name.substring(0, LONGEST_NAME) + "…" : name;
        return cut.replaceAll("\\p{Cntrl}", "?");
    }
}
