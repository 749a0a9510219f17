package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Note;

/**
 * Reads Hoppe's {@code .m} text: {@code Vertex id x y z {…}}, {@code Face id v1 v2 v3 … {…}}, {@code Corner vertex face
 * {…}}. In the braces {@code normal}, {@code uv} and {@code rgb} are attributes of wedges; those of a corner count
 * before those of its vertex. {@code rgb}, {@code mat} and {@code matid} of a face make its material. Other attributes
 * are skipped and reported.
 */
final class HoppeReader {
    private final String file;
    private final List<Note> notes;
    private final TextScanner scanner;
    private final SpoiltVertices spoilt = new SpoiltVertices();
    private final Coordinates positions = new Coordinates(1 << 12);
    private final IntMap vertexIds = new IntMap();
    private final IntMap faceIds = new IntMap();
    private final PolygonList polygons = new PolygonList();
    private final List<HoppeAttribute> attributes = List.of(
            new HoppeAttribute(Channel.Semantic.NORMAL, "normal", "normal", 3),
            new HoppeAttribute(Channel.Semantic.TEXCOORD, "uv", "uv", 2),
            new HoppeAttribute(Channel.Semantic.COLOUR, "colour", "rgb", 3));
    private final List<Material> materials = new ArrayList<>();
    private final Map<Material, Integer> materialIds = new HashMap<>();
    private final Set<String> skipped = new TreeSet<>();
    private int notFinite;
    private int firstNotFinite;
    private int strayCorners;
    private int firstStrayCorner;

    HoppeReader(String file, byte[] content, List<Note> notes) {
        this.file = file;
        this.notes = notes;
        scanner = new TextScanner(file, content, 0, true, false);
    }

    Mesh read() throws ModelFormatException {
        do {
            if (!scanner.nextOnLine()) continue;
            if (scanner.tokenIs("Vertex")) {
                vertex();
            } else if (scanner.tokenIs("Face")) {
                face();
            } else if (scanner.tokenIs("Corner")) {
                corner();
            } else if (scanner.tokenIs("Edge") || scanner.tokenIs("MVertex")) {
                skipped.add(scanner.token());
            } else {
                throw scanner.error(scanner.quote() + " where Vertex, Face or Corner should be", "Correct this line");
            }
        } while (scanner.nextLine());
        if (positions.size() == 0)
            throw scanner.error("there is no line Vertex", "Give a .m file with vertices and faces");
        if (strayCorners > 0)
            notes.add(Note.unread(
                    Notes.count(strayCorners, "Corner line") + " that name no corner of a face skipped.",
                    strayCorners,
                    "line " + firstStrayCorner));
        if (notFinite > 0)
            notes.add(Note.dropped(
                            Notes.count(notFinite, "attribute") + " left out: not finite numbers.",
                            notFinite,
                            "line " + firstNotFinite)
                    .asWarning());
        if (!skipped.isEmpty()) notes.add(Notes.unread("Skipped: " + Notes.names(skipped) + ".", skipped));
        int[] corners = polygons.vertices();
        spoilt.check(file, positions.size() / 3, corners, notes);
        Coordinates left = spoilt.without(positions);
        PolygonList.Triangles triangles = polygons.triangulate(positions.offsets(), notes);
        MeshAssembler assembler = left.assembler(spoilt.renumbered(corners), triangles.corners());
        for (HoppeAttribute attribute : attributes) {
            if (attribute.isUsed()) assembler.attribute(attribute.attribute(polygons));
        }
        MaterialUse use = new MaterialUse(triangles.materials(), materials);
        return assembler
                .materials(use.faceMaterials(), use.materials(), List.of())
                .build();
    }

    private void vertex() throws ModelFormatException {
        int id = scanner.intOnLine("the number of a vertex");
        int vertex = positions.size() / 3;
        if (!vertexIds.put(id, vertex)) throw scanner.error("Vertex " + id + " appears twice", "Remove one of them");
        for (int i = 0; i < 3; i++) coordinate(vertex, "xyz".charAt(i) + " of Vertex " + id);
        HoppeBraces braces = braces("Vertex");
        for (HoppeAttribute attribute : attributes) attribute.ofVertex(vertex, take(braces, attribute));
        skipRest(braces);
    }

    private void coordinate(int vertex, String what) throws ModelFormatException {
        if (!scanner.nextOnLine()) throw scanner.error(what + " is missing", "Complete the line");
        if (!scanner.tokenAsCoordinateOrNone(what, () -> "", positions))
            spoilt.add(vertex, () -> scanner.refusal(what));
    }

    private void face() throws ModelFormatException {
        int id = scanner.intOnLine("the number of a face");
        if (!faceIds.put(id, polygons.polygons()))
            throw scanner.error("Face " + id + " appears twice", "Remove one of them");
        while (scanner.nextOnLine() && scanner.byteAt(scanner.tokenStart()) != '{') {
            int vertexId = scanner.tokenAsInt("a corner of Face " + id);
            int vertex = vertexIds.get(vertexId);
            if (vertex < 0)
                throw scanner.error(
                        "Face " + id + " names Vertex " + vertexId + ", which is not above",
                        "Repair or remove this face");
            polygons.corner(vertex);
        }
        HoppeBraces braces = HoppeBraces.atToken(scanner);
        polygons.end(material(braces));
        skipRest(braces);
    }

    private void corner() throws ModelFormatException {
        int vertex = vertexIds.get(scanner.intOnLine("the vertex of a Corner"));
        int face = faceIds.get(scanner.intOnLine("the face of a Corner"));
        HoppeBraces braces = braces("Corner");
        float[][] values = new float[attributes.size()][];
        for (int a = 0; a < values.length; a++) values[a] = take(braces, attributes.get(a));
        boolean found = false;
        if (vertex >= 0 && face >= 0) {
            for (int corner = polygons.firstCorner(face); corner < polygons.endCorner(face); corner++) {
                if (polygons.vertex(corner) != vertex) continue;
                found = true;
                for (int a = 0; a < values.length; a++) attributes.get(a).ofCorner(corner, values[a]);
            }
        }
        if (!found && strayCorners++ == 0) firstStrayCorner = scanner.line();
        skipRest(braces);
    }

    private HoppeBraces braces(String what) throws ModelFormatException {
        if (scanner.nextOnLine() && scanner.byteAt(scanner.tokenStart()) != '{') {
            throw scanner.error(scanner.quote() + " behind the numbers of a " + what, "Put attributes in braces");
        }
        return HoppeBraces.atToken(scanner);
    }

    private float[] take(HoppeBraces braces, HoppeAttribute attribute) throws ModelFormatException {
        String text = braces.take(attribute.key());
        return text == null ? null : numbers(attribute.key(), text, attribute.components());
    }

    /** Null, and counted, when one is not finite. */
    private float[] numbers(String key, String text, int count) throws ModelFormatException {
        float[] numbers = HoppeBraces.numbers(scanner, key, text, count);
        if (numbers == null && notFinite++ == 0) firstNotFinite = scanner.line();
        return numbers;
    }

    private int material(HoppeBraces braces) throws ModelFormatException {
        String rgbText = braces.take("rgb");
        String mat = braces.take("mat");
        String id = mat == null ? braces.take("matid") : null;
        float[] rgb = rgbText == null ? null : numbers("rgb", rgbText, 3);
        if (rgb == null && mat == null && id == null) return -1;
        String name = mat != null ? mat : id != null ? "matid=" + id : FaceColour.name(rgb);
        List<Material.Parameter> parameters = rgb == null ? List.of() : List.of(new Material.Parameter("rgb", rgb));
        return materialIds.computeIfAbsent(new Material(name, parameters, List.of()), m -> {
            materials.add(m);
            return materials.size() - 1;
        });
    }

    private void skipRest(HoppeBraces braces) {
        if (skipped.size() < 1000) skipped.addAll(braces.keys());
    }
}
