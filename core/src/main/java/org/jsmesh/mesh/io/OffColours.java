package org.jsmesh.mesh.io;

import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Sizes;

/**
 * Vertex colours of an OFF file: of 8 or 16 bits when every number is whole, else floats. A colour of one number is one
 * of a table that is not in the file, see {@link ColourTable}.
 */
final class OffColours {
    private static final int WIDTH = 4;

    private final IntList bits = new IntList();
    private final BitSet whole = new BitSet();
    private final BitSet absent = new BitSet();
    private boolean allWhole = true;
    private boolean alpha;
    private float largest;
    private float largestDecimal;
    private int indexed;
    private int firstIndexed;

    /** Adds the colour of the next vertex. */
    void add(int components, float[] values, boolean integers) {
        int vertex = bits.size() / WIDTH;
        float[] rgba = values;
        boolean index = components == 1;
        if (index) {
            if (indexed++ == 0) firstIndexed = vertex;
            rgba = ColourTable.colour((int) values[0]);
        }
        boolean isWhole = integers && !index;
        int count = Math.max(3, components);
        alpha |= count == WIDTH;
        allWhole &= isWhole;
        whole.set(vertex, isWhole);
        for (int i = 0; i < WIDTH; i++) {
            float value = i < count ? rgba[i] : Float.NaN;
            bits.add(Float.floatToRawIntBits(value));
            if (i < count && !Float.isFinite(value)) absent.set(vertex);
            if (i >= count || !(value > 0)) continue;
            largest = Math.max(largest, value);
            if (!isWhole) largestDecimal = Math.max(largestDecimal, value);
        }
    }

    /** @param polygons whose corners name vertices */
    CornerAttribute attribute(PolygonList polygons, List<Note> notes) {
        int vertices = bits.size() / WIDTH;
        int components = alpha ? 4 : 3;
        boolean integers = allWhole && largest > 1 && largest <= 65535 && !hasNegative();
        Channel.Type type =
                !integers ? Channel.Type.FLOAT32 : largest <= 255 ? Channel.Type.UINT8 : Channel.Type.UINT16;
        float opaque = !integers ? 1 : largest <= 255 ? 255 : 65535;
        boolean parts = !allWhole && largestDecimal <= 1;
        int[] rows = new int[Sizes.of(components, vertices, "vertices with a colour")];
        for (int v = 0; v < vertices; v++) {
            float scale = parts && whole.get(v) && largest > 1 ? 255 : 1;
            for (int i = 0; i < components; i++) {
                float value = Float.intBitsToFloat(bits.get(v * WIDTH + i));
                if (Float.isNaN(value)) value = Math.max(opaque, scale); // no opacity given
                rows[v * components + i] = integers ? (int) value : Float.floatToRawIntBits(value / scale);
            }
        }
        Notes.leftOut(notes, "colour", absent.cardinality(), "vertex", "vertex " + absent.nextSetBit(0));
        if (indexed > 0) notes.add(tableNote(indexed, "vertex", firstIndexed));
        return new CornerAttribute(
                Channel.Semantic.COLOUR, "colour", components, type, rows, polygons.rowsWithout(absent));
    }

    private boolean hasNegative() {
        for (int i = 0; i < bits.size(); i++) if (Float.intBitsToFloat(bits.get(i)) < 0) return true;
        return false;
    }

    static Note tableNote(int count, String element, int first) {
        String text = "The colours of " + Notes.count(count, element)
                + " are numbers of a colour table that is not in the file: jSM's own colours stand for them.";
        return Note.changed(text, count, element + ' ' + first).asWarning();
    }
}
