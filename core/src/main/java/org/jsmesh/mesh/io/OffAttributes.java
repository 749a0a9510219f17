package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;

/**
 * What the vertices of an OFF file have beside their positions: a normal, a colour of three or four numbers (or one,
 * see {@link OffColours}) and a texture coordinate, in this order. Some programs write the colour before the normal;
 * then the lengths of the first normals tell.
 */
final class OffAttributes {
    private static final int LOOK_VERTICES = 16;
    private static final double UNIT = .02;

    private final TextScanner scanner;
    private final OffHeader header;
    private final IntList normalRows = new IntList();
    private final IntList texcoordRows = new IntList();
    private final BitSet badNormals = new BitSet();
    private final BitSet badTexcoords = new BitSet();
    private final OffColours colours = new OffColours();
    private final float[] colour = new float[4];
    private boolean coloursFirst;
    private int components;

    OffAttributes(TextScanner scanner, OffHeader header) {
        this.scanner = scanner;
        this.header = header;
    }

    boolean any() {
        return header.normals() || header.coloured() || header.texcoords();
    }

    /** Reads those of the next vertex, behind its position. */
    void read(int vertex) throws ModelFormatException {
        if (vertex == 0 && header.normals() && header.coloured()) coloursFirst = areColoursFirst();
        if (coloursFirst) colour(vertex);
        if (header.normals()) row(normalRows, badNormals, 3, "the normal of vertex " + vertex, vertex);
        if (header.coloured() && !coloursFirst) colour(vertex);
        if (header.texcoords())
            row(texcoordRows, badTexcoords, 2, "the texture coordinate of vertex " + vertex, vertex);
    }

    private void row(IntList rows, BitSet bad, int count, String what, int vertex) throws ModelFormatException {
        for (int i = 0; i < count; i++) {
            float value = number(what);
            if (!Float.isFinite(value)) bad.set(vertex);
            rows.add(Float.floatToRawIntBits(value));
        }
    }

    private void colour(int vertex) throws ModelFormatException {
        int behind = (header.texcoords() ? 2 : 0) + (coloursFirst ? 3 : 0);
        int count = scanner.tokensLeftOnLine() - behind;
        boolean known = count == 1 || count == 3 || count == 4;
        if (known) components = count;
        if (!known && vertex == 0)
            throw scanner.error("the first vertex has " + count + " numbers of colour", "Give three or four");
        boolean whole = true;
        for (int i = 0; i < components; i++) {
            colour[i] = number("the colour of vertex " + vertex);
            whole &= Float.isFinite(colour[i]) && scanner.numberWasInteger();
        }
        colours.add(components, colour, whole);
    }

    private float number(String what) throws ModelFormatException {
        if (!scanner.next()) throw scanner.error(what + " is missing", "The file is cut off; get it again");
        return scanner.tokenAsAnyFloat(what);
    }

    /** Looks at the next vertices: the three numbers that have the length 1 are the normal. */
    private boolean areColoursFirst() throws ModelFormatException {
        int position = scanner.position();
        int line = scanner.line();
        boolean unitFirst = true;
        boolean unitLater = true;
        for (int v = 0; v < LOOK_VERTICES; v++) {
            int count = scanner.tokensLeftOnLine();
            int later = count - (header.texcoords() ? 2 : 0) - 3;
            if (later < 1) break;
            double first = 0;
            double other = 0;
            for (int i = 0; i < later + 3; i++) {
                double value = number("a normal");
                if (i < 3) first += value * value;
                if (i >= later) other += value * value;
            }
            unitFirst &= isUnit(first);
            unitLater &= isUnit(other);
            if (!scanner.nextLine() || scanner.tokensLeftOnLine() != count + 3) break;
            for (int i = 0; i < 3; i++) scanner.nextOnLine();
        }
        scanner.backTo(position);
        scanner.countLinesFrom(line);
        return unitLater && !unitFirst;
    }

    private static boolean isUnit(double squared) {
        return Math.abs(Math.sqrt(squared) - 1) < UNIT;
    }

    /** @param polygons whose corners name vertices */
    List<CornerAttribute> attributes(PolygonList polygons, List<Note> notes) {
        List<CornerAttribute> all = new ArrayList<>();
        if (header.normals()) {
            Notes.leftOut(notes, "normal", badNormals.cardinality(), "vertex", "vertex " + badNormals.nextSetBit(0));
            all.add(new CornerAttribute(
                    Channel.Semantic.NORMAL,
                    "normal",
                    3,
                    Channel.Type.FLOAT32,
                    normalRows.toArray(),
                    polygons.rowsWithout(badNormals)));
        }
        if (header.texcoords()) {
            Notes.leftOut(notes, "uv", badTexcoords.cardinality(), "vertex", "vertex " + badTexcoords.nextSetBit(0));
            all.add(new CornerAttribute(
                    Channel.Semantic.TEXCOORD,
                    "uv",
                    2,
                    Channel.Type.FLOAT32,
                    texcoordRows.toArray(),
                    polygons.rowsWithout(badTexcoords)));
        }
        if (header.coloured() && header.vertices() > 0) all.add(colours.attribute(polygons, notes));
        return all;
    }
}
