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

    static String count(long n, String what) {
        return n + " " + what + (n == 1 ? "" : "s");
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
