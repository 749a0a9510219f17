package org.jsmesh.mesh.io;

import java.util.List;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;

/**
 * Reads OFF text (Geomview manual, section 4.2.5): {@code [ST][C][N]OFF}, see {@link OffHeader}, comments anywhere.
 * Vertices may carry what {@link OffAttributes} reads. A colour behind a face becomes a material with the parameter
 * {@code rgb}. Vertices with attributes are welded by position.
 */
final class OffReader {
    private final String file;
    private final List<Note> notes;
    private final TextScanner scanner;
    private final SpoiltVertices spoilt = new SpoiltVertices();
    private int ignored;

    OffReader(String file, byte[] content, List<Note> notes) {
        this.file = file;
        this.notes = notes;
        scanner = new TextScanner(file, content, 0, true, false);
    }

    Mesh read() throws ModelFormatException {
        OffHeader header = OffHeader.read(scanner);
        long least = 6L * header.vertices() + 2L * header.faces();
        if (least > scanner.remaining() + 2L) {
            throw scanner.error(
                    header.vertices() + " vertices and " + header.faces() + " faces cannot be in the "
                            + scanner.remaining() + " bytes that are left",
                    "The file is cut off or the counts are wrong; get it again");
        }
        OffAttributes attributes = new OffAttributes(scanner, header);
        Coordinates positions = positions(header.vertices(), attributes);
        OffFaces faces = new OffFaces(scanner, header.vertices(), notes);
        faces.read(header.faces());
        scanner.noteRest("face", notes);
        PolygonList polygons = faces.polygons();
        int[] corners = polygons.vertices();
        spoilt.check(file, header.vertices(), corners, notes);
        Coordinates left = spoilt.without(positions);
        PolygonList.Triangles triangles = polygons.triangulate(positions.offsets(), notes);
        MeshAssembler assembler = left.assembler(spoilt.renumbered(corners), triangles.corners());
        for (CornerAttribute attribute : attributes.attributes(polygons, notes))
            assembler.attribute(spoilt.kept(attribute, corners));
        faces.colours()
                .assign(assembler, polygons, triangles.materials(), header.coloured() ? "face colour" : "colour");
        return assembler.weld(attributes.any()).build();
    }

    private Coordinates positions(int vertices, OffAttributes attributes) throws ModelFormatException {
        Coordinates positions = new Coordinates(3 * vertices);
        for (int v = 0; v < vertices; v++) {
            for (int i = 0; i < 3; i++) coordinate(v, "xyz".charAt(i) + " of vertex " + v, positions);
            attributes.read(v);
            if (v == 0 && !attributes.any()) ignored = scanner.tokensLeftOnLine();
            if (ignored >= 3) scanner.restOfLine();
        }
        if (ignored >= 3) {
            String text = ignored + " more numbers per vertex than the keyword says: skipped.";
            notes.add(Note.unread(text, ignored, "vertex 0"));
        }
        return positions;
    }

    private void coordinate(int vertex, String what, Coordinates to) throws ModelFormatException {
        if (!scanner.next()) throw scanner.error(what + " is missing", "The file is cut off; get it again");
        if (!scanner.tokenAsCoordinateOrNone(what, () -> "", to)) spoilt.add(vertex, () -> scanner.refusal(what));
    }
}
