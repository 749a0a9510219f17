package org.jsmesh.mesh.io;

import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;

/**
 * Colours of the vertices of an OBJ file: three or four numbers behind the coordinates, as they are, from 0 to 1 or
 * from 0 to 255; or {@link ObjPolypaint} of 8 bits.
 */
final class ObjColours {
    private static final int WIDTH = 4;
    private static final float OPAQUE = Float.NaN;

    private final IntList rows = new IntList();
    private final BitSet coloured = new BitSet();
    private final ObjPolypaint polypaint = new ObjPolypaint();
    private boolean alpha;
    private float largest;
    private int spoilt;
    private int firstSpoilt;

    ObjPolypaint polypaint() {
        return polypaint;
    }

    /**
     * Takes the numbers behind the coordinates of a vertex.
     *
     * @param numbers red, green, blue and perhaps opacity, not finite where the file has no number
     */
    void add(int vertex, float[] numbers, int from, int count, int line) {
        for (int i = 0; i < count; i++) {
            float value = numbers[from + i];
            if (value - value == 0) continue;
            if (spoilt++ == 0) firstSpoilt = line;
            return;
        }
        while (rows.size() < WIDTH * vertex) rows.add(0);
        for (int i = 0; i < WIDTH; i++) {
            float value = i < count ? numbers[from + i] : OPAQUE;
            rows.add(Float.floatToRawIntBits(value));
            if (i < count) largest = Math.max(largest, value);
        }
        coloured.set(vertex);
        alpha |= count == WIDTH;
    }

    /** Says what of the lines is not in the colours. */
    void report(int vertices, List<Note> notes) {
        if (spoilt > 0)
            notes.add(Note.dropped(
                            Notes.count(spoilt, "colour") + " of vertices not finite, left out.",
                            spoilt,
                            "line " + firstSpoilt)
                    .asWarning());
        polypaint.report(vertices, notes);
        if (!coloured.isEmpty() && polypaint.size() > 0 && !isPolypaint())
            notes.add(Note.dropped(
                            "Colours of lines #MRGB left out, because lines v have other ones.",
                            polypaint.size(),
                            "#MRGB")
                    .asWarning());
    }

    /** Colours as an attribute, absent where a vertex has none; null when none has. */
    CornerAttribute attribute(int[] cornerVertices) {
        if (polypaint.size() > 0 && (coloured.isEmpty() || isPolypaint())) return polypaint.attribute(cornerVertices);
        if (coloured.isEmpty()) return null;
        int components = alpha ? WIDTH : WIDTH - 1;
        int opaque = Float.floatToRawIntBits(largest > 255 ? 65535 : largest > 1 ? 255 : 1);
        int[] values = new int[components * (rows.size() / WIDTH)];
        for (int i = 0; i < values.length; i++) {
            int bits = rows.get(i / components * WIDTH + i % components);
            values[i] = Float.isNaN(Float.intBitsToFloat(bits)) ? opaque : bits;
        }
        int[] cornerRows = new int[cornerVertices.length];
        for (int i = 0; i < cornerRows.length; i++)
            cornerRows[i] = coloured.get(cornerVertices[i]) ? cornerVertices[i] : -1;
        return new CornerAttribute(
                Channel.Semantic.COLOUR, "colour", components, Channel.Type.FLOAT32, values, cornerRows);
    }

    /** Whether lines #MRGB say the same colours, with their type. */
    private boolean isPolypaint() {
        if (alpha || coloured.cardinality() != polypaint.size() || coloured.length() != polypaint.size()) return false;
        for (int v = 0; v < polypaint.size(); v++) {
            for (int k = 0; k < 3; k++) {
                double level = 255.0 * Float.intBitsToFloat(rows.get(WIDTH * v + k));
                if (Math.abs(level - polypaint.value(v, k)) > .01) return false;
            }
        }
        return true;
    }
}
