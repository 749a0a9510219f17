package org.jsmesh.codec;

import org.jsmesh.mesh.CornerTable;

/** The order in which wedges get their exact values: as a flood over the faces meets them, so that most have exact neighbours on one side. */
final class WedgeOrder {
    private WedgeOrder() {}

    static int[] of(LodMesh mesh) {
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
        return order;
    }
}
