package org.jsmesh.mesh;

/**
 * Something of a model file, or of a mesh, that is not in the archive as it was. Readers, the cleaner and the encoder
 * write notes. They tell how an archive differs from its file.
 *
 * @param kind what became of it
 * @param text a sentence for people; holds {@code count} and names where they help
 * @param count how many of it there are, at least 1
 * @param example the first one: a line, the number of an element, a name in the file; empty when there is none to name.
 *     Vertices and faces are counted from 0, lines from 1
 */
public record Note(Kind kind, String text, int count, String example) {
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
     * @throws IllegalArgumentException when there is none
     */
    public Note {
        if (count < 1) throw new IllegalArgumentException("count: " + count);
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
