package org.jsmesh.test;

import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.EdgeMap;

/**
 * Checks that a corner table describes closed fans of a manifold. Faces whose first value is below
 * {@link CornerTable#OUTSIDE} were removed, and those all of whose vertices were.
 */
public final class CornerTableValidator {
    private final CornerTable table;
    private final int[] cornersAbout;
    private final EdgeMap forward;
    private final EdgeMap backward;

    private CornerTableValidator(CornerTable table) {
        this.table = table;
        cornersAbout = new int[table.vertices()];
        forward = new EdgeMap(3 * table.faces());
        backward = new EdgeMap(3 * table.faces());
    }

    /** @throws AssertionError naming the first thing found wrong */
    public static void validate(CornerTable table) {
        CornerTableValidator validator = new CornerTableValidator(table);
        for (int f = 0; f < table.faces(); f++) if (validator.isLive(f)) validator.checkFace(f);
        for (int v = 0; v < table.vertices(); v++) validator.checkFan(v);
    }

    private static void require(boolean condition, String what, int id) {
        if (!condition) throw new AssertionError(what + " " + id);
    }

    private boolean isLive(int face) {
        if (table.vertex(CornerTable.STRIDE * face) < CornerTable.OUTSIDE) return false;
        for (int c = CornerTable.STRIDE * face; c < CornerTable.STRIDE * face + 3; c++)
            if (table.vertex(c) >= 0 && table.cornerOf(table.vertex(c)) >= 0) return true;
        return false;
    }

    private void checkFace(int face) {
        int outside = 0;
        for (int c = CornerTable.STRIDE * face; c < CornerTable.STRIDE * face + 3; c++) {
            int v = table.vertex(c);
            int to = table.vertex(CornerTable.next(c));
            require(v >= CornerTable.OUTSIDE && v < table.vertices(), "vertex out of range in face", face);
            require(v != to, "an edge with equal ends in face", face);
            EdgeMap edges = v < to ? forward : backward;
            require(
                    edges.put(v, to, face) < 0,
                    "a half-edge " + v + "-" + to + " that another face has too, in face",
                    face);
            if (v == CornerTable.OUTSIDE) outside++;
            else cornersAbout[v]++;
            checkSwing(c);
        }
        require(outside < 2, "several corners outside in face", face);
    }

    private void checkSwing(int corner) {
        int to = table.swing(corner);
        require(isLive(CornerTable.face(to)), "swing into a removed face from corner", corner);
        require(table.vertex(to) == table.vertex(corner), "swing to another vertex from corner", corner);
        require(
                table.vertex(CornerTable.next(to)) == table.vertex(CornerTable.previous(corner)),
                "swing over two different edges from corner",
                corner);
        require(table.swingBack(to) == corner, "swing and back leads elsewhere from corner", corner);
    }

    private void checkFan(int vertex) {
        int start = table.cornerOf(vertex);
        if (start < 0) {
            require(cornersAbout[vertex] == 0, "faces of the removed vertex", vertex);
            return;
        }
        require(
                isLive(CornerTable.face(start)) && table.vertex(start) == vertex,
                "corner of another vertex at vertex",
                vertex);
        int n = 0;
        int dummies = 0;
        int c = start;
        do {
            if (table.isDummy(CornerTable.face(c))) dummies++;
            require(++n <= cornersAbout[vertex], "endless fan of vertex", vertex);
            c = table.swing(c);
        } while (c != start);
        require(n == cornersAbout[vertex], "several fans at vertex", vertex);
        require(dummies == 0 || dummies == 2, dummies + " dummy faces at vertex", vertex);
    }
}
