package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
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
    private final Companions companions;
    private final List<Note> notes;
    private final TextScanner scanner;

    private final ObjVertices vertices = new ObjVertices();
    private final ObjFaces faces;
    private final ObjGroups groups = new ObjGroups();
    private final ObjSkipped skipped = new ObjSkipped();
    private final Map<String, Integer> materialIds = new HashMap<>();
    private final List<String> materialNames = new ArrayList<>();
    private final MtlLibraries libraries;
    private final long filling;
    private int material = -1;

    ObjReader(String file, ByteSource content, ResourceResolver resources, List<Note> notes) throws IOException {
        this.file = file;
        companions = new Companions(resources);
        this.notes = notes;
        long end = TextFilling.end(content);
        filling = content.length() - end;
        scanner = new TextScanner(file, content, end, true, true);
        faces = new ObjFaces(file);
        libraries = new MtlLibraries(file, companions, notes);
    }

    Mesh read() throws IOException {
        do {
            if (scanner.nextOnLine()) statement();
            else vertices.colours().polypaint().read(scanner);
        } while (scanner.nextLine());
        if (vertices.size() == 0)
            throw new ModelFormatException(
                    file, "", "there is no vertex (a line \"v x y z\")", "Give an OBJ file with polygons");
        faces.check(vertices.size());
        int[] cornerVertices = faces.polygons().vertices();
        if (filling > 0)
            notes.add(Note.repaired(
                    Notes.count(filling, "byte") + " behind the text (NUL or end of file) left out.",
                    (int) Math.min(Integer.MAX_VALUE, filling),
                    ""));
        vertices.spoilt().check(file, vertices.size(), cornerVertices, notes);
        vertices.report(notes);
        skipped.report(notes);
        return assemble(cornerVertices);
    }

    private void statement() throws IOException {
        if (scanner.tokenIs("v")) {
            vertices.read(scanner);
        } else if (scanner.tokenIs("vt")) {
            faces.texcoords().read(scanner);
        } else if (scanner.tokenIs("vn")) {
            faces.normals().read(scanner);
        } else if (scanner.tokenIs("f") || scanner.tokenIs("fo")) {
            faces.read(scanner, vertices.size(), material);
        } else if (scanner.tokenIs("usemtl")) {
            useMaterial(scanner.restOfLine());
        } else if (scanner.tokenIs("mtllib")) {
            libraries.load(scanner.restOfLine());
        } else if (scanner.tokenIs("o")) {
            groups.object(scanner.restOfLine(), faces.polygons().polygons());
        } else if (scanner.tokenIs("g")) {
            groups.group(scanner.restOfLine(), faces.polygons().polygons());
        } else if (scanner.tokenIs("s")) {
            groups.smoothing(
                    scanner.nextOnLine() ? scanner.token() : "",
                    faces.polygons().polygons());
        } else {
            if (scanner.tokenHasControlCharacter())
                throw scanner.error(
                        "the line starts with " + scanner.quote() + ", which is no text", "Give an OBJ file");
            skipped.add(scanner.token(), scanner.line());
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

    private Mesh assemble(int[] cornerVertices) throws IOException {
        SpoiltVertices spoilt = vertices.spoilt();
        Coordinates left = spoilt.without(vertices.positions());
        PolygonList.Triangles triangles =
                faces.polygons().triangulate(vertices.positions().offsets(), notes);
        MeshAssembler assembler = left.assembler(spoilt.renumbered(cornerVertices), triangles.corners());
        faces.addTo(assembler, notes);
        CornerAttribute colour = vertices.colours().attribute(cornerVertices);
        if (colour != null) assembler.attribute(colour);
        groups.addTo(assembler, triangles, faces.polygons().polygons(), notes);
        MaterialUse use = new MaterialUse(triangles.materials(), libraries.definitions(materialNames));
        List<Texture> textures = new TextureLoader(companions, notes).load(use.materials());
        List<Material> materials = use.materials();
        return assembler.materials(use.faceMaterials(), materials, textures).build();
    }
}
