package org.jsmesh.mesh.io;

import java.util.List;
import org.jsmesh.mesh.Note;

/**
 * The {@code v} lines of an OBJ file: x y z, x y z w, or x y z with a colour of three or four numbers (as MeshLab and
 * ZBrush write them). A weight w matters only to curves and is left out.
 */
final class ObjVertices {
    private static final String[] NAMES = {"x", "y", "z"};
    private static final int MOST = 7;

    private final Coordinates positions = new Coordinates(1 << 12);
    private final ObjColours colours = new ObjColours();
    private final SpoiltVertices spoilt = new SpoiltVertices();
    private final float[] values = new float[MOST];
    private int weights;
    private int firstWeight;
    private int odd;
    private int firstOdd;

    int size() {
        return positions.size() / 3;
    }

    ObjColours colours() {
        return colours;
    }

    /** Those of them that are no place. */
    SpoiltVertices spoilt() {
        return spoilt;
    }

    /** Reads the line behind its keyword. */
    void read(TextScanner scanner) throws ModelFormatException {
        int count = 0;
        int vertex = size();
        while (count <= MOST && scanner.nextOnLine()) {
            if (count < NAMES.length) {
                String name = NAMES[count];
                if (!scanner.tokenAsCoordinateOrNone(name, this::vertex, positions))
                    spoilt.add(vertex, () -> scanner.refusal(name + " of vertex " + (vertex + 1)));
            } else if (count < MOST) {
                values[count] = scanner.tokenAsFloatOrNaN();
            }
            count++;
        }
        if (count < NAMES.length)
            throw scanner.error("a vertex of " + count + " numbers", "Give x y z, or x y z red green blue");
        extras(count, scanner.line());
    }

    private void extras(int count, int line) {
        switch (count) {
            case 3 -> {}
            case 4 -> {
                if (values[3] != 1 && weights++ == 0) firstWeight = line;
            }
            case 6, MOST -> colours.add(size() - 1, values, 3, count - 3, line);
            default -> {
                if (odd++ == 0) firstOdd = line;
            }
        }
    }

    /** For messages. */
    private String vertex() {
        return " of vertex " + (size() + 1);
    }

    /** Says what of the lines is not in the positions and colours. */
    void report(List<Note> notes) {
        if (weights > 0)
            notes.add(Note.dropped(
                    "Weights of vertices (w) left out; they matter to curves alone.", weights, "line " + firstWeight));
        if (odd > 0)
            notes.add(Note.unread(
                    Notes.plural(odd, "vertex", "vertices")
                            + " of 5 or more than 7 numbers, of which x y z are read; x y z red green blue has 6.",
                    odd,
                    "line " + firstOdd));
        colours.report(size(), notes);
    }

    Coordinates positions() {
        return positions;
    }
}
