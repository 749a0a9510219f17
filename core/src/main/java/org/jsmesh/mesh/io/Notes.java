package org.jsmesh.mesh.io;

import java.util.Collection;
import java.util.List;
import org.jsmesh.mesh.Note;

/** Wording of what readers and writers report. */
final class Notes {
    private static final int MOST_NAMES = 8;

    private Notes() {}

    /** One that counts names; the first is the example. */
    static Note of(Note.Kind kind, String text, Collection<String> names) {
        return new Note(kind, text, names.size(), shown(names.iterator().next()));
    }

    static Note dropped(String text, Collection<String> names) {
        return of(Note.Kind.DROPPED, text, names);
    }

    static Note unread(String text, Collection<String> names) {
        return of(Note.Kind.UNREAD, text, names);
    }

    /** A warning of attributes of the look that are no finite numbers, where there are any. */
    static void leftOut(List<Note> notes, String attribute, int count, String element, String first) {
        if (count > 0) notes.add(leftOut(attribute, count, element, first).asWarning());
    }

    /** Says that attributes are no finite numbers. */
    static Note leftOut(String attribute, int count, String element, String first) {
        String of = count > 1 && element.equals("vertex") ? count + " vertices" : count(count, element);
        String text = "The " + attribute + " of " + of + " left out: not finite numbers.";
        return Note.dropped(text, count, first);
    }

    /** One of files that were not found. */
    static Note missing(String what, String one, Collection<String> paths) {
        String text = what + " not found: " + names(paths) + ". Put the " + one + (paths.size() == 1 ? "" : "s")
                + " beside the model under " + (paths.size() == 1 ? "this name" : "these names")
                + ", and encode it again.";
        return dropped(text, paths).asWarning();
    }

    static String count(long n, String what) {
        return plural(n, what, what + "s");
    }

    static String plural(long n, String one, String several) {
        return n + " " + (n == 1 ? one : several);
    }

    /** Names for a sentence, shortened when there are many or long ones. */
    static String names(Collection<String> names) {
        List<String> shown = names.stream().limit(MOST_NAMES).map(Notes::shown).toList();
        String list = String.join(", ", shown);
        return names.size() > MOST_NAMES ? list + " and " + (names.size() - MOST_NAMES) + " more" : list;
    }

    /** A name from a file, fit for a message. */
    static String shown(String name) {
        String quoted = TokenScanner.quote(name);
        return quoted.substring(1, quoted.length() - 1);
    }
}
