package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.jsmesh.mesh.Note;

/** Statements of an OBJ file that say nothing of its faces: told by their kind, not kept. */
final class ObjSkipped {
    /** More words than these are of no language. */
    private static final int MOST_WORDS = 1000;

    private static final Set<String> FREE_FORM = Set.of(
            "vp", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end",
            "con", "bsp", "bzp", "cdc", "cdp", "res");

    private final Kind points = new Kind();
    private final Kind lines = new Kind();
    private final Kind curves = new Kind();
    private final Kind others = new Kind();

    /** Takes the word that a statement begins with. */
    void add(String word, int line) {
        Kind kind = word.equals("p") ? points : word.equals("l") ? lines : FREE_FORM.contains(word) ? curves : others;
        kind.add(word, line);
    }

    void report(List<Note> notes) {
        points.report(Note.Kind.DROPPED, "Points left out: ", " jSM streams triangles.", notes);
        lines.report(Note.Kind.DROPPED, "Lines left out: ", " jSM streams triangles.", notes);
        curves.report(
                Note.Kind.DROPPED,
                "Curves and free-form surfaces left out: ",
                " Export the model as polygons to keep them.",
                notes);
        others.report(Note.Kind.UNREAD, "Statements skipped: ", "", notes);
    }

    private static final class Kind {
        private final Map<String, Integer> words = new TreeMap<>();
        private int count;
        private int firstLine;

        void add(String word, int line) {
            if (count++ == 0) firstLine = line;
            if (words.size() < MOST_WORDS || words.containsKey(word)) words.merge(word, 1, Integer::sum);
        }

        void report(Note.Kind kind, String what, String remedy, List<Note> notes) {
            if (count == 0) return;
            List<String> list = new ArrayList<>();
            words.forEach((word, times) -> list.add(word + " (" + times + ")"));
            boolean seen = kind == Note.Kind.DROPPED; // of other statements nobody here knows what they do
            notes.add(new Note(kind, what + Notes.names(list) + "." + remedy, count, "line " + firstLine, seen));
        }
    }
}
