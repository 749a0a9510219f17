package org.jsmesh.codec.attribute;

import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.CornerTable;

/**
 * The order in which wedges get their exact values. A flood over the faces gives it, so that most wedges have exact
 * neighbours on one side.
 */
final class WedgeOrder {
    private WedgeOrder() {}

    /**
     * @param lowestLast whether vertices with fewer faces than their neighbours come last: they may have been put into
     *     polygons
     */
    static int[] of(LodMesh mesh, boolean lowestLast) {
        CornerTable t = mesh.table();
        int[] order = new int[mesh.wedges()];
        int[] queue = new int[t.faces()];
        boolean[] isQueued = new boolean[t.faces()];
        boolean[] isMet = new boolean[mesh.wedges()];
        int met = 0;
        int end = 0;
        for (int seed = 0; seed < t.faces(); seed++) {
            if (isQueued[seed] || t.isDummy(seed)) continue;
            int at = end;
            isQueued[seed] = true;
            queue[end++] = seed;
            for (; at < end; at++) {
                int corner = CornerTable.STRIDE * queue[at];
                for (int c = corner; c < corner + 3; c++) {
                    int wedge = mesh.wedge(c);
                    if (!isMet[wedge]) {
                        isMet[wedge] = true;
                        order[met++] = wedge;
                    }
                    int face = CornerTable.face(t.swing(c));
                    if (isQueued[face] || t.isDummy(face)) continue;
                    isQueued[face] = true;
                    queue[end++] = face;
                }
            }
        }
        for (int w = 0; w < isMet.length; w++) if (!isMet[w]) order[met++] = w;
        return lowestLast ? lowestLast(order, mesh) : order;
    }

    /**
     * Moves some wedges to the end: those that are the only one of a vertex that has fewer faces than each of its
     * neighbours. No two of these are neighbours.
     */
    private static int[] lowestLast(int[] order, LodMesh mesh) {
        CornerTable t = mesh.table();
        int[] valence = new int[t.vertices()];
        int end = CornerTable.STRIDE * t.faces();
        for (int c = 0; c < end; c++) if ((c & 7) < 3 && t.vertex(c) >= 0) valence[t.vertex(c)]++;
        boolean[] isEarly = new boolean[order.length];
        for (int c = 0; c < end; c++) {
            if ((c & 7) >= 3 || t.isDummy(CornerTable.face(c))) continue;
            int beside = t.swing(c);
            boolean goesOn = !t.isDummy(CornerTable.face(beside)) && mesh.wedge(beside) == mesh.wedge(c);
            if (!goesOn || valence[t.vertex(c)] >= valence[t.vertex(CornerTable.next(c))])
                isEarly[mesh.wedge(c)] = true;
        }
        int[] sorted = new int[order.length];
        int at = 0;
        for (int w : order) if (isEarly[w]) sorted[at++] = w;
        for (int w : order) if (!isEarly[w]) sorted[at++] = w;
        return sorted;
    }
}
