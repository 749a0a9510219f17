package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;

/**
 * Reads Wavefront OBJ (Appendix B1 of the Advanced Visualizer manual): polygons with optional texture coordinates and
 * normals per corner, materials, and vertex colours behind the coordinates. Free-form geometry, lines and points are
 * skipped and reported.
 */
final class ObjReader {
    private final String file;
    private final ResourceResolver resources;
    private final List<Note> notes;
    private final TextScanner scanner;

    private final ObjVertices vertices = new ObjVertices();
    private final ObjRows texcoords = new ObjRows("vt", 1, 3);
    private final ObjRows normals = new ObjRows("vn", 3, 3);
    private final PolygonList polygons = new PolygonList();
    private final IntList polygonLines = new IntList();
    private final IntList cornerTexcoords = new IntList();
    private final IntList cornerNormals = new IntList();
    private final Map<String, Integer> materialIds = new HashMap<>();
    private final List<String> materialNames = new ArrayList<>();
    private final MtlLibraries libraries;
    private final Map<String, Integer> skipped = new TreeMap<>();
    private int material = -1;
    private int skippedStatements;
    private String firstSkipped;
    private int groups;
    private String firstGroup;

    ObjReader(String file, byte[] content, ResourceResolver resources, List<Note> notes) {
        this.file = file;
        this.resources = resources;
        this.notes = notes;
        scanner = new TextScanner(file, content, 0, true, true);
        libraries = new MtlLibraries(resources, notes);
    }

    Mesh read() throws IOException {
        do {
            if (scanner.nextOnLine()) statement();
        } while (scanner.nextLine());
        if (vertices.size() == 0)
            throw new ModelFormatException(
                    file, "", "there is no vertex (a line \"v x y z\")", "Give an OBJ file with polygons");
        checkIndices();
        vertices.report(notes);
        if (groups > 0)
            notes.add(Note.dropped(Notes.count(groups, "group and object name") + " not kept.", groups, firstGroup));
        if (!skipped.isEmpty()) {
            List<String> list = new ArrayList<>();
            skipped.forEach((word, count) -> list.add(word + " (" + count + ")"));
            String text = "Statements skipped: " + Notes.names(list) + ".";
            notes.add(Note.unread(text, skippedStatements, firstSkipped));
        }
        return assemble();
    }

    private void statement() throws IOException {
        if (scanner.tokenIs("v")) {
            vertices.read(scanner);
        } else if (scanner.tokenIs("vt")) {
            texcoords.read(scanner);
        } else if (scanner.tokenIs("vn")) {
            normals.read(scanner);
        } else if (scanner.tokenIs("f") || scanner.tokenIs("fo")) {
            face();
        } else if (scanner.tokenIs("usemtl")) {
            useMaterial(scanner.restOfLine());
        } else if (scanner.tokenIs("mtllib")) {
            libraries.load(scanner.restOfLine());
        } else if (scanner.tokenIs("g") || scanner.tokenIs("o")) {
            if (groups++ == 0) firstGroup = Notes.shown(scanner.restOfLine());
        } else if (!scanner.tokenIs("s")) {
            if (scanner.tokenHasControlCharacter())
                throw scanner.error(
                        "the line starts with " + scanner.quote() + ", which is no text", "Give an OBJ file");
            if (skippedStatements++ == 0) firstSkipped = "line " + scanner.line();
            if (skipped.size() < 1000) skipped.merge(scanner.token(), 1, Integer::sum);
        }
    }

    private void useMaterial(String name) {
        if (name.isEmpty()) {
            material = -1;
            return;
        }
        material = materialIds.computeIfAbsent(name, n -> {
            materialNames.add(n);
            return materialNames.size() - 1;
        });
    }

    private void face() throws ModelFormatException {
        while (scanner.nextOnLine()) {
            int end = scanner.tokenEnd();
            int slash = find('/', scanner.tokenStart(), end);
            polygons.corner(resolve(scanner.tokenStart(), slash, vertices.size(), "the vertex of a corner"));
            int second = slash == end ? end : find('/', slash + 1, end);
            cornerTexcoords.add(
                    slash + 1 >= second
                            ? -1
                            : resolve(slash + 1, second, texcoords.size(), "the texture coordinate of a corner"));
            cornerNormals.add(
                    second + 1 >= end ? -1 : resolve(second + 1, end, normals.size(), "the normal of a corner"));
        }
        polygons.end(material);
        polygonLines.add(scanner.line());
    }

    private int find(char wanted, int start, int end) {
        int at = start;
        while (at < end && scanner.byteAt(at) != wanted) at++;
        return at;
    }

    /**
     * Turns an index that counts from 1, or back from the latest, into one from 0. Whether the row exists is checked at
     * the end, because it may come later.
     */
    private int resolve(int start, int end, int count, String what) throws ModelFormatException {
        int index = scanner.parseInt(start, end, what);
        int resolved = index > 0 ? index - 1 : count + index;
        if (index == 0 || resolved < 0) {
            throw scanner.error(what + " is " + index + " where there are " + count, "Count from 1, or back from −1");
        }
        return resolved;
    }

    private void checkIndices() throws ModelFormatException {
        for (int polygon = 0; polygon < polygons.polygons(); polygon++) {
            for (int corner = polygons.firstCorner(polygon); corner < polygons.endCorner(polygon); corner++) {
                checkIndex(polygons.vertex(corner), vertices.size(), "v", polygon);
                checkIndex(cornerTexcoords.get(corner), texcoords.size(), "vt", polygon);
                checkIndex(cornerNormals.get(corner), normals.size(), "vn", polygon);
            }
        }
    }

    private void checkIndex(int index, int count, String what, int polygon) throws ModelFormatException {
        if (index < count) return;
        throw new ModelFormatException(
                file,
                "line " + polygonLines.get(polygon),
                "a corner names " + what + " number " + (index + 1L) + " but there are only " + count,
                "Repair or remove this face");
    }

    private Mesh assemble() throws IOException {
        float[] positions = vertices.positions();
        PolygonList.Triangles triangles = polygons.triangulate(positions, notes);
        MeshAssembler assembler = new MeshAssembler(positions, polygons.vertices(), triangles.corners());
        CornerAttribute normal = normals.attribute(Channel.Semantic.NORMAL, "normal", cornerNormals.toArray());
        if (normal != null) assembler.attribute(normal);
        CornerAttribute uv = texcoords.attribute(Channel.Semantic.TEXCOORD, "uv", cornerTexcoords.toArray());
        if (uv != null) assembler.attribute(uv);
        CornerAttribute colour = vertices.colours(polygons.vertices());
        if (colour != null) assembler.attribute(colour);
        MaterialUse use = new MaterialUse(triangles.materials(), libraries.definitions(materialNames));
        List<Texture> textures = new TextureLoader(resources, notes).load(use.materials());
        List<Material> materials = use.materials();
        return assembler.materials(use.faceMaterials(), materials, textures).build();
    }
}
