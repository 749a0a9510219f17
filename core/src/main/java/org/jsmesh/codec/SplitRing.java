package org.jsmesh.codec;

import org.jsmesh.mesh.CornerTable;

/** The faces about a vertex that splits, slot by slot: its corners, its neighbours, and how likely each edge is to leave the vertex. */
final class SplitRing {
    private static final int UNKNOWN_SHAPE = 24;
    private static final int SLOTS = ConnectivityCoder.MAX_VALENCE + 1;
    private static final int MOST_VALENCE = 12;
    private final LodMesh mesh;
    private final int[] offset = new int[3 * SLOTS];
    private int vertex;
    private int slots;

    /** Corners of the vertex. */
    final int[] corner = new int[SLOTS];

    /** Whether this pass has used the face of a slot. */
    final boolean[] used = new boolean[SLOTS];

    /** Vertex at the start of each slot. */
    final int[] neighbour = new int[SLOTS];

    /** Faces about each neighbour, counted up to 12. */
    final int[] valences = new int[SLOTS];

    /** Of the edge before a slot: 0..63, or negative when it cannot be interior. */
    final int[] shape = new int[SLOTS];

    SplitRing(LodMesh mesh) {
        this.mesh = mesh;
    }

    /** Collects the faces about a vertex. */
    void walk(int split, int faces, int pass) {
        vertex = split;
        slots = faces;
        CornerTable t = mesh.table();
        int[] data = t.data();
        int c = t.cornerOf(vertex);
        for (int n = 0; n < slots; n++) {
            corner[n] = c;
            used[n] = data[c | 3] == pass;
            c = data[c + 4];
        }
    }

    /**
     * How likely each edge of the ring is to leave the vertex: length² against the square of the diagonal that would replace it, on a logarithmic scale. Edges beside a used face cannot.
     * Returns the number of edges that can.
     *
     * @param state valence of each vertex at 2 v
     */
    int measureEdges(int[] state) {
        int[] data = mesh.table().data();
        int[] cells = mesh.cells();
        int largest = 0;
        for (int j = 0; j < slots; j++) {
            int x = data[CornerTable.next(corner[j])];
            neighbour[j] = x;
            valences[j] = x < 0 ? 6 : Math.min(state[2 * x], MOST_VALENCE);
            // Between two used faces lies perhaps a vertex of this pass, whose position is not decoded yet.
            if (used[j] && used[j == 0 ? slots - 1 : j - 1]) continue;
            for (int a = 0; a < 3; a++) {
                int d = x < 0 ? 0 : cells[3 * x + a] - cells[3 * vertex + a];
                offset[3 * j + a] = d;
                largest |= d < 0 ? -d : d;
            }
        }
        int shift = Math.max(0, IntegerLog.bits(largest) - 13);
        int candidates = 0;
        for (int j = 0; j < slots; j++) {
            int before = j == 0 ? slots - 1 : j - 1;
            int after = j + 1 == slots ? 0 : j + 1;
            if (used[before] || used[j]) {
                shape[j] = -1;
                continue;
            }
            candidates++;
            if (neighbour[before] < 0 || neighbour[j] < 0 || neighbour[after] < 0) {
                shape[j] = UNKNOWN_SHAPE;
                continue;
            }
            int edge = 1;
            int diagonal = 1;
            for (int a = 0; a < 3; a++) {
                int d = offset[3 * j + a] >> shift;
                edge += d * d;
                int e = (offset[3 * before + a] >> shift) - (offset[3 * after + a] >> shift);
                diagonal += e * e;
            }
            shape[j] = Math.max(0, Math.min(63, IntegerLog.log8(edge) - IntegerLog.log8(diagonal) + 32));
        }
        return candidates;
    }
}
