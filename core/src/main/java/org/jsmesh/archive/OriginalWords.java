package org.jsmesh.archive;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Note;

/**
 * What people are told of an archive whose original was proved: how much of the file that is. Command, page and window
 * say the same.
 */
public final class OriginalWords {
    private static final int MOST = 8;
    private static final String[] VERBS = {" not kept", " dropped", " left out", " skipped"};

    private OriginalWords() {}

    /**
     * Says what was proved.
     *
     * @param from the file, and what of it was lost
     * @return a clause: that it is identical to the file's geometry, materials and pictures; or, where a loss is seen
     *     or measured, that it is not the whole original, and why
     */
    public static String claim(Provenance from) {
        if (!hasWarning(from)) return "identical to the original file's geometry, materials and pictures";
        return warning(from);
    }

    /**
     * Says that a loss is seen or measured, proved or not.
     *
     * @param from the file, and what of it was lost
     * @return a clause; empty when no loss is a warning
     */
    public static String warning(Provenance from) {
        List<String> losses = new ArrayList<>();
        for (Note note : from.notes()) if (note.warning()) losses.add(clause(note.text()));
        return losses.isEmpty() ? "" : "not the whole original: " + list(losses);
    }

    /**
     * Says what else was lost.
     *
     * @param from the file, and what of it was lost
     * @return a clause; empty when nothing was
     */
    public static String notKept(Provenance from) {
        List<String> losses = new ArrayList<>();
        for (Note note : from.notes())
            if (note.isLoss() && !note.warning()) losses.add(withoutVerb(clause(note.text())));
        return losses.isEmpty() ? "" : "of the file not kept: " + list(losses);
    }

    /**
     * Tells whether a loss is seen or measured.
     *
     * @param from the file, and what of it was lost
     * @return true when one of the notes is a warning
     */
    public static boolean hasWarning(Provenance from) {
        for (Note note : from.notes()) if (note.warning()) return true;
        return false;
    }

    private static String list(List<String> losses) {
        String first = String.join("; ", losses.subList(0, Math.min(MOST, losses.size())));
        return losses.size() > MOST ? first + "; and " + (losses.size() - MOST) + " more" : first;
    }

    /** The sentence without its full stop and its first capital. */
    private static String clause(String sentence) {
        String text = sentence.endsWith(".") ? sentence.substring(0, sentence.length() - 1) : sentence;
        if (text.length() < 2 || isCapital(text.charAt(1)) || !isCapital(text.charAt(0))) return text;
        return (char) (text.charAt(0) + ('a' - 'A')) + text.substring(1);
    }

    private static boolean isCapital(char c) {
        return c >= 'A' && c <= 'Z';
    }

    private static String withoutVerb(String clause) {
        for (String verb : VERBS)
            if (clause.endsWith(verb)) return clause.substring(0, clause.length() - verb.length());
        return clause;
    }
}
