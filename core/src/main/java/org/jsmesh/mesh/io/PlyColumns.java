package org.jsmesh.mesh.io;

import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Sizes;

/** Properties of a PLY element that make one attribute, and the raw values of its rows as in {@link Channel}. */
final class PlyColumns {
    /** float64 holds all whole numbers below. */
    private static final double EXACT = 0x1p53;

    private final Channel.Semantic semantic;
    private final String name;
    private final int[] columns;
    private final Channel.Type type;
    private final boolean whole;
    private final int[] values;
    private final BitSet notFinite = new BitSet();
    private int rounded;
    private int firstRounded;

    /**
     * @param whole whether the file has whole numbers, which float64 may round
     * @param rows of the element
     */
    PlyColumns(Channel.Semantic semantic, String name, int[] columns, Channel.Type type, boolean whole, int rows) {
        this.semantic = semantic;
        this.name = name;
        this.columns = columns;
        this.type = type;
        this.whole = whole;
        values = new int[Sizes.of(columns.length * type.words(), rows, "rows with " + name)];
    }

    /** A scalar of the file's own meaning. */
    static PlyColumns scalar(String name, int column, PlyType type, int rows) {
        return new PlyColumns(
                Channel.Semantic.CUSTOM, name, new int[] {column}, type.channelType(), type.isInteger(), rows);
    }

    Channel.Semantic semantic() {
        return semantic;
    }

    String name() {
        return name;
    }

    /** Places of the properties in their element, by component. */
    int[] columns() {
        return columns;
    }

    void set(int row, int component, double value) {
        int at = (row * columns.length + component) * type.words();
        if (type == Channel.Type.FLOAT32) {
            float single = (float) value;
            if (!Float.isFinite(single)) notFinite.set(row);
            else if (single != value) countRounded(row);
            values[at] = Float.floatToRawIntBits(single);
        } else if (type == Channel.Type.FLOAT64) {
            if (!Double.isFinite(value)) notFinite.set(row);
            if (whole && Math.abs(value) >= EXACT) countRounded(row);
            long bits = Double.doubleToRawLongBits(value);
            values[at] = (int) bits;
            values[at + 1] = (int) (bits >>> 32);
        } else {
            values[at] = (int) (long) value;
        }
    }

    private void countRounded(int row) {
        if (rounded++ == 0) firstRounded = row;
    }

    /** Notes values that are not what the file has. */
    void noteRounded(List<Note> notes, String element) {
        if (rounded == 0) return;
        String text = Notes.count(rounded, name + " value") + " rounded to "
                + (type == Channel.Type.FLOAT64 ? "float64." : "float32.");
        notes.add(Note.changed(text, rounded, element + ' ' + firstRounded));
    }

    /** Notes rows that lack the attribute, for they have numbers that are not finite. */
    void noteAbsent(List<Note> notes) {
        int count = notFinite.cardinality();
        if (count == 0) return;
        Note note = Notes.leftOut(name, count, "vertex", "vertex " + notFinite.nextSetBit(0));
        notes.add(semantic == Channel.Semantic.CUSTOM ? note : note.asWarning());
    }

    CornerAttribute ofCorners(PolygonList polygons) {
        return new CornerAttribute(semantic, name, columns.length, type, values, polygons.rowsWithout(notFinite));
    }

    /**
     * @param firstPolygon the polygon of the first row
     * @param polygonOfTriangle the polygon that each triangle is cut from
     */
    FaceChannel ofFaces(int firstPolygon, int[] polygonOfTriangle) {
        int words = type.words();
        int[] ofTriangles = new int[Sizes.of(words, polygonOfTriangle.length, "faces with " + name)];
        for (int t = 0; t < polygonOfTriangle.length; t++) {
            int from = (polygonOfTriangle[t] - firstPolygon) * words;
            // triangles of strips have 0
            if (from >= 0 && from < values.length) System.arraycopy(values, from, ofTriangles, t * words, words);
        }
        return new FaceChannel(name, 1, type, ofTriangles, List.of());
    }
}
