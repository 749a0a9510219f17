package org.jsmesh.codec.connectivity;

import org.jsmesh.codec.entropy.IntegerLog;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.CornerTable;

/**
 * The faces about a vertex that splits, slot by slot: its corners, its neighbours, and how likely each edge is to leave
 * the vertex. An edge belongs to the slot behind it.
 */
final class SplitRing {
    private static final int UNKNOWN_SHAPE = 24;
    private static final int SLOTS = ConnectivityCoder.MAX_VALENCE + 1;
    private static final int INDEX_BITS = 7;
    private static final int INDEX = (1 << INDEX_BITS) - 1;
    private final LodMesh mesh;
    private final int[] x = new int[SLOTS]; // of the neighbours from the vertex, in cells
    private final int[] y = new int[SLOTS];
    private final int[] z = new int[SLOTS];
    private final int[] rank = new int
            [SLOTS]; // of the edges: shape, and below it how early the slot is; −1 for edges that are no candidates
    private final int[] square = new int[SLOTS]; // of the edges' lengths, in units that fit; 0 where not known
    private final int[] edge = new int[SLOTS]; // what is known of each edge, see CutModel
    private int slots;
    private int best; // rank of a candidate, when the vertex begins to split
    private int second; // and the next one
    private int magnitude; // at least as many bits as the largest of x, y, z

    /** Corners of the vertex. */
    final int[] corner = new int[SLOTS];

    /** Whether this pass has used the face of a slot. */
    final boolean[] used = new boolean[SLOTS];

    /** Vertex at the start of each slot. */
    final int[] neighbour = new int[SLOTS];

    /** Faces about each neighbour, dummy ones too. */
    final int[] valences = new int[SLOTS];

    SplitRing(LodMesh mesh) {
        this.mesh = mesh;
    }

    /**
     * Measures the edges from a vertex. Returns how many of them may leave it: those between faces that the pass has
     * not used.
     *
     * @param state of each vertex, see {@link ConnectivityCoder#valence}
     */
    int measure(int vertex, int faces, int pass, int[] state) {
        slots = faces;
        walk(vertex, pass, state);
        int shift = Math.max(0, IntegerLog.bits(magnitude) - 13);
        int usual = measureLengths(shift);
        int candidates = 0;
        best = 0;
        second = 0;
        int before = slots - 1;
        for (int j = 0; j < slots; j++) {
            int length = square[j] == 0 ? 0 : IntegerLog.log8(square[j] + 1);
            int shape = UNKNOWN_SHAPE;
            if (used[before] || used[j]) {
                rank[j] = -1;
            } else {
                candidates++;
                shape = shape(before, j, j + 1 == slots ? 0 : j + 1, length, shift);
                rank[j] = shape << INDEX_BITS | INDEX - j;
            }
            second = Math.max(second, Math.min(best, rank[j]));
            best = Math.max(best, rank[j]);
            int size = square[j] == 0 ? 3 : Math.max(0, Math.min(7, (3 * (length - usual) >> 4) + 4));
            edge[j] = CutModel.edge(shape, size, valences[j]);
            before = j;
        }
        return candidates;
    }

    /** Measures all edges and returns the logarithm of a usual square. */
    private int measureLengths(int shift) {
        int sum = 0;
        int known = 0;
        for (int j = 0; j < slots; j++) {
            square[j] = 0;
            if (neighbour[j] < 0) continue;
            int ex = x[j] >> shift;
            int ey = y[j] >> shift;
            int ez = z[j] >> shift;
            square[j] = ex * ex + ey * ey + ez * ez;
            if (square[j] == 0) continue;
            sum += square[j] >> 6;
            known++;
        }
        return known == 0 ? 0 : IntegerLog.log8(sum / known + 1) + 48;
    }

    private void walk(int vertex, int pass, int[] state) {
        int[] data = mesh.table().data();
        int[] places = mesh.places();
        int atX = places[4 * vertex];
        int atY = places[4 * vertex + 1];
        int atZ = places[4 * vertex + 2];
        int all = 0;
        int c = mesh.table().cornerOf(vertex);
        boolean usedBefore = data[c | 3] == pass && data[mesh.table().swingBack(c) | 3] == pass;
        for (int n = 0; n < slots; n++) {
            corner[n] = c;
            boolean isUsed = data[c | 3] == pass;
            used[n] = isUsed;
            int v = data[CornerTable.next(c)];
            neighbour[n] = v;
            if (v < 0) {
                valences[n] = ConnectivityCoder.REGULAR;
            } else {
                valences[n] = ConnectivityCoder.valence(state[v]);
                // Between two used faces there may be a vertex of this pass, whose position is not decoded yet.
                int known = isUsed && usedBefore ? 0 : -1;
                int dx = places[4 * v] - atX & known;
                int dy = places[4 * v + 1] - atY & known;
                int dz = places[4 * v + 2] - atZ & known;
                x[n] = dx;
                y[n] = dy;
                z[n] = dz;
                all |= Math.abs(dx) | Math.abs(dy) | Math.abs(dz);
            }
            usedBefore = isUsed;
            c = data[c + 4];
        }
        magnitude = all;
    }

    /**
     * Ratio of an edge's squared length to that of the diagonal that would replace it, on a logarithmic scale of 0 to
     * 63.
     */
    private int shape(int before, int j, int after, int length, int shift) {
        if ((neighbour[before] | neighbour[j] | neighbour[after]) < 0) return UNKNOWN_SHAPE;
        int dx = (x[before] >> shift) - (x[after] >> shift);
        int dy = (y[before] >> shift) - (y[after] >> shift);
        int dz = (z[before] >> shift) - (z[after] >> shift);
        int diagonal = dx * dx + dy * dy + dz * dz + 1;
        return Math.max(0, Math.min(63, length - IntegerLog.log8(diagonal) + 32));
    }

    /** The edge most likely to leave the vertex, the first of several. */
    int longest() {
        return INDEX - (best & INDEX);
    }

    /** The next one after that. */
    int secondLongest() {
        return INDEX - (second & INDEX);
    }

    /** The edge most likely to leave the vertex but for a candidate, the first of several. */
    int longestBut(int candidate) {
        int most = 0;
        for (int j = 0; j < slots; j++) if (j != candidate) most = Math.max(most, rank[j]);
        return INDEX - (most & INDEX);
    }

    /** What the model of cuts knows of an edge. */
    int edge(int j) {
        return edge[j];
    }

    /** Makes an edge no candidate any more. */
    void exclude(int edge) {
        rank[edge] = -1;
    }

    /** Whether an edge may leave the vertex. */
    boolean isCandidate(int edge) {
        return rank[edge] >= 0;
    }

    /** How likely a candidate is to leave the vertex: 0 to 63. */
    int shape(int edge) {
        return rank[edge] >> INDEX_BITS;
    }
}
