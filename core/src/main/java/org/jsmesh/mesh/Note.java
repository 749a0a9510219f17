package org.jsmesh.mesh;

/**
 * Something of a model file, or of a mesh, that is not in the archive as it was. Readers, the cleaner and the encoder
 * write notes. They tell how an archive differs from its file. Archives hold the notes of what was lost.
 *
 * @param kind what became of it
 * @param text a sentence for people; holds {@code count} and names where they help
 * @param count how many of it there are, at least 1
 * @param example the first one: a line, the number of an element, a name in the file; empty when there is none to name.
 *     Vertices and faces are counted from 0, lines from 1
 * @param warning is it a loss that is seen or measured: positions moved by more than a hundred-thousandth of the
 *     diagonal, faces, instances, textures or colours that are missing, normals or texture coordinates that were
 *     refused?
 */
public record Note(Kind kind, String text, int count, String example, boolean warning) {
    /** What became of something, from harmless to unknown. */
    public enum Kind {
        /** It was mended, and nothing is lost by it. */
        REPAIRED,
        /** It was read and is not in the archive. */
        DROPPED,
        /** It is in the archive with another value or in another form. */
        CHANGED,
        /** It was skipped: an extension, an element, a property or a line that no reader here knows. */
        UNREAD
    }

    /**
     * Checks the count.
     *
     * @param kind see {@link #kind()}
     * @param text see {@link #text()}
     * @param count see {@link #count()}
     * @param example see {@link #example()}
     * @param warning see {@link #warning()}
     * @throws IllegalArgumentException when there is none
     */
    public Note {
        if (count < 1) throw new IllegalArgumentException("count: " + count);
    }

    /**
     * Makes a note that is no warning.
     *
     * @param kind see {@link #kind()}
     * @param text see {@link #text()}
     * @param count see {@link #count()}
     * @param example see {@link #example()}
     */
    public Note(Kind kind, String text, int count, String example) {
        this(kind, text, count, example, false);
    }

    /**
     * Makes a warning of the note.
     *
     * @return a note that differs in that alone
     */
    public Note asWarning() {
        return new Note(kind, text, count, example, true);
    }

    /** {@return true when something was lost: of every kind but {@link Kind#REPAIRED}} */
    public boolean isLoss() {
        return kind != Kind.REPAIRED;
    }

    /**
     * Makes a note of {@link Kind#REPAIRED}.
     *
     * @param text a sentence for people
     * @param count how many of it there are
     * @param example where the first one is, or empty
     * @return the note
     */
    public static Note repaired(String text, int count, String example) {
        return new Note(Kind.REPAIRED, text, count, example);
    }

    /**
     * Makes a note of {@link Kind#DROPPED}.
     *
     * @param text a sentence for people
     * @param count how many of it there are
     * @param example where the first one is, or empty
     * @return the note
     */
    public static Note dropped(String text, int count, String example) {
        return new Note(Kind.DROPPED, text, count, example);
    }

    /**
     * Makes a note of {@link Kind#CHANGED}.
     *
     * @param text a sentence for people
     * @param count how many of it there are
     * @param example where the first one is, or empty
     * @return the note
     */
    public static Note changed(String text, int count, String example) {
        return new Note(Kind.CHANGED, text, count, example);
    }

    /**
     * Makes a note of {@link Kind#UNREAD}.
     *
     * @param text a sentence for people
     * @param count how many of it there are
     * @param example where the first one is, or empty
     * @return the note
     */
    public static Note unread(String text, int count, String example) {
        return new Note(Kind.UNREAD, text, count, example);
    }
}
