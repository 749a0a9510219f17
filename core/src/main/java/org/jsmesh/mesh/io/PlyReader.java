package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;

/**
 * Reads PLY: vertices, faces, triangle strips, colours of both. Vertices with normals, texture coordinates or colours
 * are welded, because files write a seam of attributes as several vertices at one position. Other vertices stay as the
 * file has them.
 */
final class PlyReader {
    private final String file;
    private final ByteSource content;
    private final ResourceResolver resources;
    private final List<Note> notes;

    PlyReader(String file, ByteSource content, ResourceResolver resources, List<Note> notes) {
        this.file = file;
        this.content = content;
        this.resources = resources;
        this.notes = notes;
    }

    Mesh read() throws java.io.IOException {
        TextScanner scanner = new TextScanner(file, content, content.length(), false, false);
        PlyHeader header = PlyHeader.parse(scanner, content, notes);
        PlyData data = PlyData.of(file, scanner, header);
        PlyHeader.Element vertex = header.element("vertex");
        if (vertex == null)
            throw new ModelFormatException(
                    file, "", "there is no element \"vertex\"", "Give a PLY file with vertices and faces");
        PlyVertices vertices = null;
        PlyFaces faces = new PlyFaces(vertex.count(), header.textures().size(), notes);
        List<String> skipped = new ArrayList<>();
        for (PlyHeader.Element element : header.elements()) {
            checkSize(element, data);
            switch (element.name()) {
                case "vertex" -> {
                    vertices = new PlyVertices(file, element, notes);
                    vertices.read(data);
                }
                case "face" -> faces.readFaces(element, data);
                case "tristrips" -> faces.readStrips(element, data);
                default -> {
                    skipped.add(element.name());
                    skip(element, data);
                }
            }
        }
        if (!skipped.isEmpty()) notes.add(Notes.unread("Elements skipped: " + Notes.names(skipped) + ".", skipped));
        data.noteRest(notes);
        return assemble(vertices, faces, textures(header));
    }

    /** In the names that MeshLab writes, {@code <this>} stands for the name of the PLY file without its extension. */
    private List<String> textures(PlyHeader header) {
        return header.textures().stream()
                .map(path -> path.replace("<this>", FileNames.stem(file)))
                .toList();
    }

    private Mesh assemble(PlyVertices vertices, PlyFaces faces, List<String> textureFiles) throws java.io.IOException {
        int[] corners = faces.polygons().vertices();
        SpoiltVertices spoilt = vertices.spoilt();
        spoilt.check(file, vertices.positions().size() / 3, corners, notes);
        Coordinates left = spoilt.without(vertices.positions());
        PolygonList.Triangles triangles =
                faces.polygons().triangulate(vertices.positions().offsets(), notes);
        MeshAssembler assembler = left.assembler(spoilt.renumbered(corners), triangles.corners());
        List<CornerAttribute> attributes = vertices.attributes(faces.polygons());
        for (CornerAttribute attribute : attributes) assembler.attribute(spoilt.kept(attribute, corners));
        CornerAttribute uv =
                faces.cornerTexcoords(attributes.stream().anyMatch(a -> a.name().equals("uv")) ? "uv1" : "uv");
        if (uv != null) assembler.attribute(uv);
        boolean coloured = attributes.stream().anyMatch(a -> a.semantic() == Channel.Semantic.COLOUR);
        String faceColours = coloured ? "face colour" : "colour";
        faces.materials(assembler, triangles.materials(), textureFiles, resources, faceColours);
        faces.scalars(assembler, triangles.polygons());
        return assembler.weld(!attributes.isEmpty()).build();
    }

    /** Checks the counts, so that nothing is allocated for elements that the file cannot hold. */
    private void checkSize(PlyHeader.Element element, PlyData data) throws ModelFormatException {
        long each = 0;
        for (PlyHeader.Property p : element.properties())
            each += data.leastBytes(p.isList() ? p.countType() : p.type());
        if (each * element.count() > data.remaining() + 1L) {
            throw data.error(
                    "element " + Notes.shown(element.name()) + " needs at least " + each * element.count()
                            + " bytes but " + data.remaining() + " are left",
                    "The file is cut off; get it again");
        }
    }

    private static void skip(PlyHeader.Element element, PlyData data) throws ModelFormatException {
        long bytes = element.bytesOfScalars();
        if (element.properties().isEmpty() || bytes >= 0 && data.skips(bytes * element.count())) return;
        for (int i = 0; i < element.count(); i++) {
            for (PlyHeader.Property p : element.properties()) skip(p, data);
        }
    }

    static void skip(PlyHeader.Property property, PlyData data) throws ModelFormatException {
        int values = property.isList() ? data.readCount(property) : 1;
        for (int i = 0; i < values; i++) data.read(property.type());
    }
}
