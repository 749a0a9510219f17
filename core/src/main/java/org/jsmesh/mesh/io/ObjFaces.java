package org.jsmesh.mesh.io;

import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;

/** The {@code f} lines of an OBJ file: corners {@code v}, {@code v/vt}, {@code v//vn} or {@code v/vt/vn}. */
final class ObjFaces {
    private final String file;
    private final PolygonList polygons = new PolygonList();
    private final IntList lines = new IntList();
    private final ObjRows texcoords = new ObjRows("vt", "texture coordinate", 1);
    private final ObjRows normals = new ObjRows("vn", "normal", 3);

    ObjFaces(String file) {
        this.file = file;
    }

    ObjRows texcoords() {
        return texcoords;
    }

    ObjRows normals() {
        return normals;
    }

    PolygonList polygons() {
        return polygons;
    }

    /**
     * Reads the line behind its keyword.
     *
     * @param vertices how many there are so far
     * @param material −1 for none
     */
    void read(TextScanner scanner, int vertices, int material) throws ModelFormatException {
        while (scanner.nextOnLine()) {
            int start = scanner.tokenStart();
            int end = scanner.tokenEnd();
            int slash = find(scanner, start, end);
            int second = find(scanner, slash + 1, end);
            polygons.corner(vertex(scanner, start, slash, vertices));
            texcoords.corner(scanner, slash + 1, second);
            normals.corner(scanner, second + 1, end);
        }
        polygons.end(material);
        lines.add(scanner.line());
    }

    private static int find(TextScanner scanner, int start, int end) {
        int at = start;
        while (at < end && scanner.byteAt(at) != '/') at++;
        return at;
    }

    /**
     * Turns an index that counts from 1, or back from the latest vertex, into one from 0. Whether the vertex exists is
     * checked at the end, because it may come later.
     */
    private static int vertex(TextScanner scanner, int start, int end, int count) throws ModelFormatException {
        int index = scanner.parseInt(start, end, "the vertex of a corner");
        int resolved = index > 0 ? index - 1 : count + index;
        if (index == 0 || resolved < 0)
            throw scanner.error(
                    "the vertex of a corner is " + index + " where there are " + count,
                    "Count from 1, or back from −1");
        return resolved;
    }

    /** Refuses corners that name a vertex which the file does not have. */
    void check(int vertices) throws ModelFormatException {
        for (int corner = 0; corner < polygons.corners(); corner++) {
            int vertex = polygons.vertex(corner);
            if (vertex < vertices) continue;
            throw new ModelFormatException(
                    file,
                    "line " + line(corner),
                    "a corner names v number " + (vertex + 1L) + " but there are only " + vertices,
                    "Repair or remove this face");
        }
    }

    /** Gives an assembler what corners have beside vertices. */
    void addTo(MeshAssembler assembler, List<Note> notes) {
        CornerAttribute normal = normals.attribute(Channel.Semantic.NORMAL, "normal", this::line, notes);
        if (normal != null) assembler.attribute(normal);
        CornerAttribute uv = texcoords.attribute(Channel.Semantic.TEXCOORD, "uv", this::line, notes);
        if (uv != null) assembler.attribute(uv);
    }

    private int line(int corner) {
        int low = 0;
        int high = polygons.polygons() - 1;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (polygons.endCorner(middle) > corner) high = middle;
            else low = middle + 1;
        }
        return lines.get(low);
    }
}
