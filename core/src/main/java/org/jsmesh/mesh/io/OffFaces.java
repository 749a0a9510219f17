package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Material;

/** The faces of an OFF file, each with an optional colour on the rest of its line. */
final class OffFaces {
    private final TextScanner scanner;
    private final int vertices;
    private final PolygonList polygons = new PolygonList();
    private final List<Material> materials = new ArrayList<>();
    private final Map<Material, Integer> ids = new HashMap<>();
    private final float[] colour = new float[4];

    OffFaces(TextScanner scanner, int vertices) {
        this.scanner = scanner;
        this.vertices = vertices;
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
            polygons.end(material());
        }
    }

    private int next(String what) throws ModelFormatException {
        if (!scanner.next()) throw scanner.error(what + " is missing", "The file is cut off; get it again");
        return scanner.tokenAsInt(what);
    }

    /** Three or four numbers are a colour; one is an index into a table that is not in the file. */
    private int material() throws ModelFormatException {
        int count = 0;
        boolean whole = true;
        while (scanner.nextOnLine()) {
            if (count < 4) {
                colour[count] = scanner.tokenAsFloat("the colour of a face");
                whole &= scanner.numberWasInteger();
            }
            count++;
        }
        if (count != 3 && count != 4) return -1;
        float scale = whole ? 255f : 1f;
        List<Material.Parameter> parameters = new ArrayList<>();
        parameters.add(new Material.Parameter("rgb", colour[0] / scale, colour[1] / scale, colour[2] / scale));
        if (count == 4) parameters.add(new Material.Parameter("d", colour[3] / scale));
        return ids.computeIfAbsent(
                new Material(FaceColour.name(parameters.get(0).values()), parameters, List.of()), m -> {
                    materials.add(m);
                    return materials.size() - 1;
                });
    }

    PolygonList polygons() {
        return polygons;
    }

    List<Material> materials() {
        return materials;
    }
}
