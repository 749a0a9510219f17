package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;

/**
 * Reads OFF text (Geomview manual, section 4.2.5): {@code [ST][C][N]OFF}, comments anywhere, counts on the first line
 * or the second. Vertices may carry normals, colours of three or four numbers (whole numbers are 0 to 255) and texture
 * coordinates, in this order. A colour behind a face becomes a material with the parameter {@code rgb}. Vertices with
 * attributes are welded by position.
 */
final class OffReader {
    private final String file;
    private final List<Note> notes;
    private final TextScanner scanner;
    private final OffColours colours = new OffColours();
    private boolean normals;
    private boolean coloured;
    private boolean texcoords;
    private int colourComponents;
    private int ignored;

    OffReader(String file, byte[] content, List<Note> notes) {
        this.file = file;
        this.notes = notes;
        scanner = new TextScanner(file, content, 0, true, false);
    }

    /** Whether a word is the first of an OFF file. */
    static boolean isKeyword(String word) {
        return word.toUpperCase(Locale.ROOT).matches("(ST)?C?N?4?N?OFF");
    }

    Mesh read() throws ModelFormatException {
        if (!scanner.next()) throw scanner.error("the file is empty", "Give an OFF file");
        if (isKeyword(scanner.token())) {
            keyword(scanner.token().toUpperCase(Locale.ROOT));
            if (!scanner.next()) throw scanner.error("the counts are missing", "The file is cut off; get it again");
            if (scanner.tokenIs("BINARY"))
                throw scanner.error("binary OFF is not supported", "Convert it to text or to PLY");
        }
        int vertices = count("vertices");
        scanner.intOnLine("the number of faces");
        int faces = count("faces");
        scanner.restOfLine();
        long least = 6L * vertices + 2L * faces;
        if (least > scanner.remaining() + 2L) {
            throw scanner.error(
                    vertices + " vertices and " + faces + " faces cannot be in the " + scanner.remaining()
                            + " bytes that are left",
                    "The file is cut off or the counts are wrong; get it again");
        }
        return readElements(vertices, faces);
    }

    private void keyword(String word) throws ModelFormatException {
        String flags = word.substring(0, word.length() - 3);
        if (flags.contains("4") || flags.endsWith("NN") || scanner.tokenIs("nOFF")) {
            throw scanner.error(
                    "vertices of " + scanner.quote() + " are not three-dimensional", "Convert the model to OFF or PLY");
        }
        texcoords = flags.startsWith("ST");
        coloured = flags.contains("C");
        normals = flags.endsWith("N");
    }

    private int count(String what) throws ModelFormatException {
        int count = scanner.tokenAsInt("the number of " + what);
        if (count < 0) throw scanner.error("the number of " + what + " is " + count, "Correct the counts");
        return count;
    }

    private Mesh readElements(int vertices, int faces) throws ModelFormatException {
        float[] positions = new float[3 * vertices];
        IntList normalRows = new IntList();
        IntList texcoordRows = new IntList();
        for (int v = 0; v < vertices; v++) {
            for (int i = 0; i < 3; i++) positions[3 * v + i] = number("xyz".charAt(i) + " of vertex " + v);
            for (int i = 0; normals && i < 3; i++)
                normalRows.add(Float.floatToRawIntBits(number("the normal of vertex " + v)));
            if (coloured) colour(v);
            for (int i = 0; texcoords && i < 2; i++)
                texcoordRows.add(Float.floatToRawIntBits(number("the texture coordinate of vertex " + v)));
            if (v == 0 && !normals && !coloured && !texcoords) ignored = scanner.tokensLeftOnLine();
            if (ignored >= 3) scanner.restOfLine();
        }
        if (ignored >= 3) {
            String text = ignored + " more numbers per vertex than the keyword says: skipped.";
            notes.add(Note.unread(text, ignored, "vertex 0"));
        }
        OffFaces faceReader = new OffFaces(scanner, vertices);
        faceReader.read(faces);
        if (scanner.next()) notes.add(Note.unread("Text behind the last face skipped.", 1, "line " + scanner.line()));
        PolygonList polygons = faceReader.polygons();
        PolygonList.Triangles triangles = polygons.triangulate(positions, notes);
        MaterialUse use = new MaterialUse(triangles.materials(), faceReader.materials());
        List<Material> materials = use.materials();
        MeshAssembler assembler = new MeshAssembler(positions, polygons.vertices(), triangles.corners());
        assembler.materials(use.faceMaterials(), materials, List.of());
        List<CornerAttribute> attributes = new ArrayList<>();
        if (normals)
            attributes.add(new CornerAttribute(
                    Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, normalRows.toArray(), null));
        if (texcoords)
            attributes.add(new CornerAttribute(
                    Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, texcoordRows.toArray(), null));
        if (coloured && vertices > 0) attributes.add(colours.attribute(file, colourComponents));
        attributes.forEach(assembler::attribute);
        return assembler.weld(!attributes.isEmpty()).build();
    }

    /** Three numbers or four, as in the line of the first vertex. */
    private void colour(int vertex) throws ModelFormatException {
        if (vertex == 0) {
            colourComponents = scanner.tokensLeftOnLine() - (texcoords ? 2 : 0);
            if (colourComponents != 3 && colourComponents != 4) {
                throw scanner.error(
                        "the first vertex has " + colourComponents + " numbers of colour", "Give three or four");
            }
        }
        for (int i = 0; i < colourComponents; i++) {
            float value = number("the colour of vertex " + vertex);
            colours.add(value, scanner.numberWasInteger());
        }
    }

    private float number(String what) throws ModelFormatException {
        if (!scanner.next()) throw scanner.error(what + " is missing", "The file is cut off; get it again");
        return scanner.tokenAsFloat(what);
    }
}
