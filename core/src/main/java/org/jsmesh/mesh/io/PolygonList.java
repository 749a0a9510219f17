package org.jsmesh.mesh.io;

import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Sizes;

/**
 * The polygons of a file in order, as corners that name vertices. Readers keep what else a corner has in lists of their
 * own, parallel to the corners. Triangles come at the end, when all positions are known.
 */
final class PolygonList {
    private static final int TRIANGLE = 3;

    private final IntList vertices = new IntList();
    private final IntList ends = new IntList();
    private final IntList materials = new IntList();
    private int tooShort;
    private int firstTooShort;
    private boolean onlyTriangles = true;

    /** Makes room for so many polygons, most of them triangles. */
    void expect(int polygons) {
        if (polygons > (Sizes.MOST - vertices.size()) / TRIANGLE) return;
        vertices.reserve(vertices.size() + TRIANGLE * polygons);
        ends.reserve(ends.size() + polygons);
        materials.reserve(materials.size() + polygons);
    }

    void corner(int vertex) {
        vertices.add(vertex);
    }

    /** Ends the polygon that the last corners belong to. */
    void end(int material) {
        int corners = vertices.size() - (ends.size() == 0 ? 0 : ends.get(ends.size() - 1));
        if (corners < TRIANGLE && tooShort++ == 0) firstTooShort = polygons();
        if (corners != TRIANGLE) onlyTriangles = false;
        ends.add(vertices.size());
        materials.add(material);
    }

    int polygons() {
        return ends.size();
    }

    int corners() {
        return vertices.size();
    }

    int vertex(int corner) {
        return vertices.get(corner);
    }

    /** Vertex of every corner. */
    int[] vertices() {
        return vertices.toArray();
    }

    int material(int polygon) {
        return materials.get(polygon);
    }

    /** The vertex of every corner, −1 for vertices that lack an attribute; null when none does. */
    int[] rowsWithout(BitSet absent) {
        if (absent.isEmpty()) return null;
        int[] rows = vertices().clone();
        for (int c = 0; c < rows.length; c++) if (absent.get(rows[c])) rows[c] = -1;
        return rows;
    }

    int firstCorner(int polygon) {
        return polygon == 0 ? 0 : ends.get(polygon - 1);
    }

    int endCorner(int polygon) {
        return ends.get(polygon);
    }

    /**
     * @param corners three corner numbers per triangle
     * @param materials of each triangle
     * @param polygons that each triangle is cut from
     */
    record Triangles(int[] corners, int[] materials, int[] polygons) {
        /** The value of each triangle, from those of polygons. */
        int[] ofPolygons(int[] values) {
            int[] ofTriangles = new int[polygons.length];
            for (int i = 0; i < ofTriangles.length; i++) ofTriangles[i] = values[polygons[i]];
            return ofTriangles;
        }
    }

    /** Cuts polygons of more than three corners and says so. Leaves out those of fewer. */
    Triangles triangulate(float[] positions, List<Note> notes) {
        if (onlyTriangles) {
            int[] corners = new int[corners()];
            for (int i = 0; i < corners.length; i++) corners[i] = i;
            int[] polygons = new int[polygons()];
            for (int i = 0; i < polygons.length; i++) polygons[i] = i;
            return new Triangles(corners, materials.toArray(), polygons);
        }
        int[] all = vertices();
        PolygonTriangulator triangulator = new PolygonTriangulator(positions);
        IntList corners = new IntList(all.length);
        IntList faceMaterials = new IntList(polygons());
        IntList origins = new IntList(polygons());
        int cut = 0;
        int firstCut = 0;
        int concave = 0;
        int givenUp = 0;
        int firstGivenUp = 0;
        for (int polygon = 0, from = 0; polygon < polygons(); polygon++) {
            int to = ends.get(polygon);
            if (to - from >= 3) {
                PolygonTriangulator.Cut how = triangulator.cut(all, from, to, corners);
                if (to - from > 3 && cut++ == 0) firstCut = polygon;
                if (how == PolygonTriangulator.Cut.EARS) concave++;
                if (how == PolygonTriangulator.Cut.GIVEN_UP && givenUp++ == 0) firstGivenUp = polygon;
                while (3 * faceMaterials.size() < corners.size()) {
                    faceMaterials.add(materials.get(polygon));
                    origins.add(polygon);
                }
            }
            from = to;
        }
        if (cut > 0) {
            String text = Notes.count(cut, "polygon") + " with more than three corners cut into triangles, " + concave
                    + " of them concave.";
            notes.add(Note.changed(text, cut, "face " + firstCut));
        }
        if (givenUp > 0) {
            String text = Notes.count(givenUp, "concave polygon") + " too large for ear clipping, cut as a fan.";
            notes.add(Note.changed(text, givenUp, "face " + firstGivenUp).asWarning());
        }
        if (tooShort > 0) {
            String text = Notes.count(tooShort, "face") + " with fewer than three corners left out.";
            notes.add(Note.dropped(text, tooShort, "face " + firstTooShort));
        }
        return new Triangles(corners.toArray(), faceMaterials.toArray(), origins.toArray());
    }
}
