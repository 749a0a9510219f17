package org.jsmesh.mesh.io;

import java.util.List;
import org.jsmesh.mesh.Note;

/** The faces of an OFF file, each with an optional colour on the rest of its line. */
final class OffFaces {
    private static final int MOST_COMPONENTS = 4;

    private final TextScanner scanner;
    private final int vertices;
    private final List<Note> notes;
    private final PolygonList polygons = new PolygonList();
    private final FaceColours colours;
    private final float[] colour = new float[MOST_COMPONENTS];
    private int badColours;
    private int firstBadColour;
    private int indexed;
    private int firstIndexed;
    private int unknown;
    private int firstUnknown;

    OffFaces(TextScanner scanner, int vertices, List<Note> notes) {
        this.scanner = scanner;
        this.vertices = vertices;
        this.notes = notes;
        colours = new FaceColours(notes);
    }

    void read(int faces) throws ModelFormatException {
        for (int face = 0; face < faces; face++) {
            int corners = next("the number of corners of face " + face);
            if (corners < 0 || 2L * corners > scanner.remaining() + 1L) {
                throw scanner.error(
                        "face " + face + " has " + corners + " corners",
                        "The file is cut off or damaged; get it again");
            }
            for (int i = 0; i < corners; i++) {
                int vertex = next("a corner of face " + face);
                if (vertex < 0 || vertex >= vertices) {
                    throw scanner.error(
                            "face " + face + " names vertex " + vertex + " of " + vertices,
                            "Repair or remove this face");
                }
                polygons.corner(vertex);
            }
            polygons.end(colour(face));
        }
        Notes.leftOut(notes, "colour", badColours, "face", "face " + firstBadColour);
        if (indexed > 0) notes.add(OffColours.tableNote(indexed, "face", firstIndexed));
        if (unknown > 0) {
            String text = "Numbers behind " + Notes.count(unknown, "face") + " that are no colour skipped.";
            notes.add(Note.unread(text, unknown, "face " + firstUnknown));
        }
    }

    private int next(String what) throws ModelFormatException {
        if (!scanner.next()) throw scanner.error(what + " is missing", "The file is cut off; get it again");
        return scanner.tokenAsInt(what);
    }

    /** Three or four numbers are a colour; one is an index into a table that is not in the file. */
    private int colour(int face) throws ModelFormatException {
        int count = 0;
        boolean whole = true;
        boolean finite = true;
        while (scanner.nextOnLine()) {
            if (count < MOST_COMPONENTS) {
                colour[count] = scanner.tokenAsAnyFloat("the colour of a face");
                boolean number = Float.isFinite(colour[count]);
                finite &= number;
                whole &= number && scanner.numberWasInteger();
            }
            count++;
        }
        if (count == 0) return -1;
        if (!finite) {
            if (badColours++ == 0) firstBadColour = face;
            return -1;
        }
        if (count == 1) {
            if (indexed++ == 0) firstIndexed = face;
            return colours.add(-1, FaceColours.Range.DECIMAL, 3, ColourTable.colour((int) colour[0]));
        }
        if (count != 3 && count != MOST_COMPONENTS) {
            if (unknown++ == 0) firstUnknown = face;
            return -1;
        }
        return colours.add(-1, whole ? FaceColours.Range.TEXT : FaceColours.Range.DECIMAL, count, colour);
    }

    PolygonList polygons() {
        return polygons;
    }

    FaceColours colours() {
        return colours;
    }
}
