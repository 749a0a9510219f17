package org.jsmesh.codec.connectivity;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.CornerTable;

/**
 * Codes whether the new fan vertex of a split belongs to a mesh vertex that is there already, and to which. Most
 * stitches are along borders that several sheets share. The mesh vertex is then on another sheet, next to a fan of one
 * of the new vertex' neighbours along the border.
 */
public final class StitchCoder {
    private static final int NONE = -1;
    private static final int MOST_FANS = 8; // of a neighbour
    private static final int MOST_STEPS = 3; // from a neighbour along another sheet's border
    private static final int MOST_CANDIDATES = 48;
    private static final int RANKS = 8;
    private final LodMesh mesh;
    private final EncoderTruth truth; // encoder only
    private final int[] stitched = BinaryCoder.newContexts(5);
    private final int[] chosen = BinaryCoder.newContexts(2 * RANKS);
    private final int[] candidate = new int[MOST_CANDIDATES]; // mesh vertices
    private final boolean[] isBetween = new boolean[MOST_CANDIDATES]; // both neighbours
    private int candidates;

    public StitchCoder(LodMesh mesh, EncoderTruth truth) {
        this.mesh = mesh;
        this.truth = truth;
    }

    /** Codes the mesh vertex of fan vertex u, which a split has just made. Returns its number, or that of a new one. */
    int code(BinaryCoder coder, int u) {
        int context = findCandidates(u);
        int original = truth == null ? NONE : truth.originalVertex(u);
        int known = truth == null ? NONE : truth.codedVertex(original);
        if (coder.bit(stitched, context, known >= 0 ? 1 : 0) != 0) return codeKnown(coder, known);
        int vertex = mesh.addVertex();
        if (truth != null) truth.codedAs(original, vertex);
        return vertex;
    }

    private int codeKnown(BinaryCoder coder, int known) {
        int rank = 0;
        for (int round = 0; round < 2; round++) {
            for (int i = 0; i < candidates; i++) {
                if (isBetween[i] != (round == 0)) continue;
                int context = round * RANKS + Math.min(rank++, RANKS - 1);
                if (coder.bit(chosen, context, candidate[i] == known ? 1 : 0) != 0) return candidate[i];
            }
        }
        return coder.uniform(known, mesh.vertices());
    }

    /** Lists the candidates and returns the context of whether there is a stitch. */
    private int findCandidates(int u) {
        CornerTable t = mesh.table();
        candidates = 0;
        int border = border(u);
        if (border < 0) return 0;
        int p = t.vertex(CornerTable.previous(border));
        int q = t.vertex(CornerTable.next(t.swingBack(border)));
        boolean fromP = mesh.isStitched(p);
        boolean fromQ = mesh.isStitched(q);
        if (fromP) collect(p, q, 0);
        int ofP = candidates;
        if (fromQ) collect(q, p, ofP);
        boolean between = false;
        for (int i = 0; i < ofP; i++) between |= isBetween[i];
        return between ? 4 : 1 + (fromP ? 1 : 0) + (fromQ ? 1 : 0);
    }

    /** The corner of a vertex in the dummy face that follows its border, or −1 within a sheet. */
    private int border(int fan) {
        int[] data = mesh.table().data();
        int start = mesh.table().cornerOf(fan);
        int c = start;
        for (int n = 0; n <= ConnectivityCoder.MAX_VALENCE; n++) {
            if (data[CornerTable.next(c)] == CornerTable.OUTSIDE) return c;
            c = data[c + 4];
            if (c == start) break;
        }
        return NONE;
    }

    /**
     * Adds what lies along the borders of the other fans of a neighbour.
     *
     * @param other the neighbour at the other side
     * @param before number of candidates that were found from that neighbour
     */
    private void collect(int neighbour, int other, int before) {
        CornerTable t = mesh.table();
        int end = mesh.vertexOf(other);
        int fan = mesh.firstFan(mesh.vertexOf(neighbour));
        for (int n = 0; n < MOST_FANS; n++) {
            int border = fan == neighbour ? NONE : border(fan);
            for (int ahead = border, i = 0; ahead >= 0 && i < MOST_STEPS; i++) {
                ahead = t.swing(CornerTable.previous(ahead));
                if (!add(t.vertex(ahead), neighbour, end, before)) break;
            }
            for (int back = border, i = 0; back >= 0 && i < MOST_STEPS; i++) {
                back = CornerTable.next(t.swingBack(back));
                if (!add(t.vertex(back), neighbour, end, before)) break;
            }
            fan = mesh.nextFan(fan);
            if (fan == 0) break;
        }
    }

    /** Adds a candidate. Returns false where the border has come to the new vertex or one of its neighbours. */
    private boolean add(int fan, int neighbour, int end, int before) {
        if (fan >= mesh.fans()) return false; // the new one: it has no mesh vertex yet
        int vertex = mesh.vertexOf(fan);
        if (vertex == end || vertex == mesh.vertexOf(neighbour)) return false;
        for (int i = 0; i < candidates; i++) {
            if (candidate[i] != vertex) continue;
            if (i < before) isBetween[i] = true;
            return true;
        }
        if (candidates == MOST_CANDIDATES) return false;
        candidate[candidates] = vertex;
        isBetween[candidates++] = false;
        return true;
    }
}
