package org.jsmesh.mesh.io;

import java.util.BitSet;
import java.util.List;
import java.util.function.IntUnaryOperator;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;

/**
 * The {@code vt} or {@code vn} lines of an OBJ file, and which of them each corner names. A row that is incomplete or
 * no finite number, and an index without a row, cost the corner its attribute and not the file its mesh. Numbers that a
 * {@code vt} line leaves out are 0.
 */
final class ObjRows {
    private static final int WIDTH = 3;
    private static final int NONE = -1;
    /** Of a corner that names a row which cannot be. */
    private static final int WRONG = -2;

    private final String keyword;
    private final String noun;
    private final int least;
    private final IntList values = new IntList();
    private final IntList corners = new IntList();
    private final BitSet spoilt = new BitSet();
    private int firstSpoilt;
    private boolean third;

    /**
     * @param noun what a row is, for notes
     * @param least numbers of a whole row
     */
    ObjRows(String keyword, String noun, int least) {
        this.keyword = keyword;
        this.noun = noun;
        this.least = least;
    }

    int size() {
        return values.size() / WIDTH;
    }

    /** Reads the line behind its keyword. */
    void read(TextScanner scanner) {
        int row = size();
        int count = 0;
        boolean finite = true;
        while (count < WIDTH && scanner.nextOnLine()) {
            float value = scanner.tokenAsFloatOrNaN();
            finite &= value - value == 0;
            int bits = Float.floatToRawIntBits(value);
            values.add(bits);
            if (++count == WIDTH && bits != 0) third = true;
        }
        if (!finite || count < least) {
            if (spoilt.isEmpty()) firstSpoilt = scanner.line();
            spoilt.set(row);
        }
        while (count++ < WIDTH) values.add(0);
    }

    /**
     * Takes the index of the next corner, which counts from 1, or back from the latest row. Whether the row exists is
     * checked at the end, because it may come later.
     *
     * @param start first byte of the index in the scanner's token; where it is not before {@code end}, there is none
     */
    void corner(TextScanner scanner, int start, int end) {
        if (start >= end) {
            corners.add(NONE);
            return;
        }
        int index = scanner.wholeNumber(start, end);
        int row = index > 0 ? index - 1 : size() + index;
        corners.add(index == TextScanner.NO_NUMBER || index == 0 || row < 0 ? WRONG : row);
    }

    /**
     * The attribute of all corners; null when there are no rows. Texture coordinates have two components unless a third
     * one is not 0.
     *
     * @param lineOfCorner where a corner stands in the file
     */
    CornerAttribute attribute(Channel.Semantic semantic, String name, IntUnaryOperator lineOfCorner, List<Note> notes) {
        int[] cornerRows = corners.toArray();
        int wrong = 0;
        int firstWrong = 0;
        for (int corner = 0; corner < cornerRows.length; corner++) {
            int row = cornerRows[corner];
            if (row >= 0 && row < size() && !spoilt.get(row) || row == NONE) continue;
            cornerRows[corner] = NONE;
            if (row >= 0 && row < size()) continue;
            if (wrong++ == 0) firstWrong = corner;
        }
        if (!spoilt.isEmpty()) {
            int count = spoilt.cardinality();
            String text = Notes.count(count, noun) + " (" + keyword + ") that " + (count == 1 ? "is" : "are")
                    + " incomplete or not finite left out.";
            notes.add(Note.dropped(text, count, "line " + firstSpoilt).asWarning());
        }
        if (wrong > 0) {
            String text =
                    Notes.count(wrong, "corner") + " without " + noun + ": " + (wrong == 1 ? "it names" : "they name")
                            + " a " + keyword + " that is not among the " + size() + " of the file.";
            notes.add(Note.dropped(text, wrong, "line " + lineOfCorner.applyAsInt(firstWrong))
                    .asWarning());
        }
        if (size() == 0) return null;
        int components = least == WIDTH || third ? WIDTH : 2;
        int[] rows = new int[size() * components];
        for (int i = 0; i < rows.length; i++) rows[i] = values.get(i / components * WIDTH + i % components);
        return new CornerAttribute(semantic, name, components, Channel.Type.FLOAT32, rows, cornerRows);
    }
}
