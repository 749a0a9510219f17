package org.jsmesh.archive;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Note;

/**
 * Where the mesh of an archive came from, and what of that is not in the archive.
 *
 * @param format name of the file's format, such as {@code PLY}; empty when there was no file
 * @param notes what of the file was lost, in the order in which it was found; an archive has at most
 *     {@link #MOST_NOTES}
 */
public record Provenance(String format, List<Note> notes) {
    /** Notes that an archive holds. */
    public static final int MOST_NOTES = 64;

    /** Characters of a note's text. */
    public static final int MOST_TEXT = 300;

    /** Characters of a note's example. */
    public static final int MOST_EXAMPLE = 100;

    /** A mesh that did not come from a file. */
    public static final Provenance NONE = new Provenance("", List.of());

    /**
     * Copies the list.
     *
     * @param format see {@link #format()}
     * @param notes see {@link #notes()}
     */
    public Provenance {
        notes = List.copyOf(notes);
    }

    /**
     * Gives what an archive holds of this: the notes of losses, with short texts. Beyond the room for them, the last
     * note counts the others. It is a warning if one of those is.
     *
     * @return one with at most {@link #MOST_NOTES} notes
     */
    public Provenance bounded() {
        List<Note> losses = new ArrayList<>();
        for (Note note : notes) if (note.isLoss()) losses.add(bounded(note));
        if (losses.size() > MOST_NOTES) {
            List<Note> left = losses.subList(MOST_NOTES - 1, losses.size());
            Note last = Note.dropped(left.size() + " more notes left out.", left.size(), "");
            boolean warning = false;
            for (Note note : left) warning |= note.warning();
            losses = new ArrayList<>(losses.subList(0, MOST_NOTES - 1));
            losses.add(warning ? last.asWarning() : last);
        }
        return new Provenance(PlainText.fit(format, MOST_EXAMPLE), losses);
    }

    private static Note bounded(Note note) {
        return new Note(
                note.kind(),
                PlainText.fit(note.text(), MOST_TEXT),
                note.count(),
                PlainText.fit(note.example(), MOST_EXAMPLE),
                note.warning());
    }
}
