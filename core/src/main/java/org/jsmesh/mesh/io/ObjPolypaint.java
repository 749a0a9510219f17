package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;

/**
 * Colours in comments of an OBJ file, as ZBrush writes them: lines {@code #MRGB} with eight hexadecimal digits per
 * vertex, which are a mask, red, green and blue. They go on from line to line in the order of the vertices.
 */
final class ObjPolypaint {
    private static final String KEYWORD = "#MRGB";
    /** Most vertices of a line that is written. */
    private static final int PER_LINE = 64;

    private static final int DIGITS = 8;
    /** Whole in the mask: the vertex is not masked. */
    private static final int UNMASKED = 255;

    private final IntList values = new IntList();
    private int masks;
    private int firstMask;
    private int damaged;
    private int firstDamaged;

    /** Vertices that have a colour: the first ones. */
    int size() {
        return values.size() / 3;
    }

    int value(int vertex, int component) {
        return values.get(3 * vertex + component);
    }

    /** Takes a comment; false when it is none of these lines. */
    boolean read(TextScanner scanner) {
        int at = scanner.lineStart();
        if (!scanner.hasAt(at, KEYWORD)) return false;
        at += KEYWORD.length();
        while (scanner.isBlankAt(at)) at++;
        int digits = 0;
        int entry = 0;
        for (int digit = scanner.hexDigitAt(at); digit >= 0; digit = scanner.hexDigitAt(++at)) {
            entry = entry << 4 | digit;
            if (++digits % DIGITS == 0) add(entry, scanner.line());
        }
        while (scanner.isBlankAt(at)) at++;
        if ((digits % DIGITS != 0 || !scanner.isLineEndAt(at)) && damaged++ == 0) firstDamaged = scanner.line();
        return true;
    }

    private void add(int entry, int line) {
        if (entry >>> 24 != UNMASKED && masks++ == 0) firstMask = line;
        for (int shift = 16; shift >= 0; shift -= 8) values.add(entry >> shift & 255);
    }

    /** Says what of the lines is not in the colours. */
    void report(int vertices, List<Note> notes) {
        if (damaged > 0)
            notes.add(Note.dropped(
                    Notes.count(damaged, "line") + " #MRGB not whole, read as far as it is hexadecimal.",
                    damaged,
                    "line " + firstDamaged));
        if (masks > 0)
            notes.add(Note.dropped("Masks of lines #MRGB not kept, their colours are.", masks, "line " + firstMask));
        int left = size() - vertices;
        if (left > 0)
            notes.add(Note.dropped(
                    Notes.count(left, "colour") + " of lines #MRGB left over behind the last vertex.", left, "#MRGB"));
        else if (left < 0 && size() > 0)
            notes.add(Note.repaired(
                    "Lines #MRGB have no colour for the last " + Notes.plural(-left, "vertex", "vertices") + ".",
                    -left,
                    "vertex " + size()));
    }

    /** Colours as an attribute, absent at vertices behind the last colour. */
    CornerAttribute attribute(int[] cornerVertices) {
        int[] cornerRows = new int[cornerVertices.length];
        for (int i = 0; i < cornerRows.length; i++) cornerRows[i] = cornerVertices[i] < size() ? cornerVertices[i] : -1;
        return new CornerAttribute(
                Channel.Semantic.COLOUR, "colour", 3, Channel.Type.UINT8, values.toArray(), cornerRows);
    }

    /**
     * Writes colours behind the vertices.
     *
     * @param colours red, green, blue of each vertex, 0 to 255
     */
    static void write(TextOutput out, int[] colours) throws IOException {
        for (int from = 0; from < colours.length; from += 3 * PER_LINE) {
            out.text(KEYWORD + " ");
            int end = Math.min(from + 3 * PER_LINE, colours.length);
            for (int i = from; i < end; i += 3) {
                int rgb = colours[i] << 16 | colours[i + 1] << 8 | colours[i + 2];
                out.text(Integer.toHexString(UNMASKED << 24 | rgb));
            }
            out.line();
        }
    }
}
