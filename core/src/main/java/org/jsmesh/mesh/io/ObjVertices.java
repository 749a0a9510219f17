package org.jsmesh.mesh.io;

import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;

/**
 * The {@code v} lines of an OBJ file: x y z, x y z w, or x y z with a colour of three or four numbers (as MeshLab and
 * ZBrush write them). A weight w matters only to curves and is left out.
 */
final class ObjVertices {
    private static final String[] NAMES = {"x", "y", "z"};
    private static final int ONE = Float.floatToRawIntBits(1f);

    private final IntList positions = new IntList(1024);
    private final IntList colours = new IntList();
    private final BitSet coloured = new BitSet();
    private final float[] values = new float[7];
    private boolean alpha;
    private int weights;
    private int firstWeight;

    int size() {
        return positions.size() / 3;
    }

    void read(TextScanner scanner) throws ModelFormatException {
        int count = 0;
        while (scanner.nextOnLine()) {
            if (count == values.length)
                throw scanner.error("a vertex of more than 7 numbers", "Give x y z, or x y z red green blue");
            values[count] = scanner.tokenAsFloat(count < 3 ? NAMES[count] : "a number", this::vertex);
            count++;
        }
        if (count < 3 || count == 5)
            throw scanner.error("a vertex of " + count + " numbers", "Give x y z, or x y z red green blue");
        if (count == 4 && values[3] != 1 && weights++ == 0) firstWeight = scanner.line();
        for (int i = 0; i < 3; i++) positions.add(Float.floatToRawIntBits(values[i]));
        if (count >= 6) colour(count);
    }

    /** For messages. */
    private String vertex() {
        return " of vertex " + (size() + 1);
    }

    private void colour(int count) {
        int vertex = size() - 1;
        while (colours.size() < 4 * vertex) colours.add(0);
        for (int i = 3; i < 6; i++) colours.add(Float.floatToRawIntBits(values[i]));
        colours.add(count == 7 ? Float.floatToRawIntBits(values[6]) : ONE);
        coloured.set(vertex);
        alpha |= count == 7;
    }

    /** Says what of the lines is not in the positions and colours. */
    void report(List<Note> notes) {
        if (weights > 0) notes.add(Note.dropped("Weights of vertices (w) left out.", weights, "line " + firstWeight));
    }

    float[] positions() {
        return positions.toFloats();
    }

    /** Vertex colours as an attribute, absent where a vertex has none; null when none has. */
    CornerAttribute colours(int[] cornerVertices) {
        if (coloured.isEmpty()) return null;
        int components = alpha ? 4 : 3;
        int[] rows = new int[components * (colours.size() / 4)];
        for (int i = 0; i < rows.length; i++) rows[i] = colours.get(i / components * 4 + i % components);
        int[] cornerRows = new int[cornerVertices.length];
        for (int i = 0; i < cornerRows.length; i++)
            cornerRows[i] = coloured.get(cornerVertices[i]) ? cornerVertices[i] : -1;
        return new CornerAttribute(
                Channel.Semantic.COLOUR, "colour", components, Channel.Type.FLOAT32, rows, cornerRows);
    }
}
