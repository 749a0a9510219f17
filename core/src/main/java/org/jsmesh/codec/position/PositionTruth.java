package org.jsmesh.codec.position;

import org.jsmesh.codec.lattice.Lattice;
import org.jsmesh.codec.lattice.LatticeCoder;
import org.jsmesh.codec.lod.ArrayGrowth;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.lod.Renumbering;

/**
 * The positions that an encoder wants: the original's, or, in coarse levels, those where a fit has moved the vertices.
 * A decoder has an object of this class that knows nothing.
 */
public final class PositionTruth {
    private final LodMesh mesh;
    private final Lattice lattice;
    private final LatticeCoder[] points;
    private final float[] originals; // the original's positions; null for a decoder
    private int[] bits = new int[3 * 64]; // of the mesh's vertices, float32
    private int[] cells = new int[3 * 64];
    private int[] moves; // cells by which a fit moves the original's vertices; null where none does
    private int[] movesBefore; // by which the known vertices are moved

    /** The cells of the vertex asked for last. */
    final int[] wanted = new int[3];

    PositionTruth(LodMesh mesh, Lattice lattice, LatticeCoder[] points, float[] originals) {
        this.mesh = mesh;
        this.lattice = lattice;
        this.points = points;
        this.originals = originals;
    }

    /** The exact positions of vertices that were {@linkplain #find found}: float32 bits, three per mesh vertex. */
    int[] bits() {
        return bits;
    }

    /** Sets the moves of a fit in cells, three per vertex of the original; null: the true positions. */
    public void move(int[] by) {
        moves = by;
    }

    /** Must an encoder say which vertices of the original it codes? If not, any number will do. */
    public boolean isMoved() {
        return moves != null;
    }

    /** Notes that all vertices have moved to where they should be. */
    public void haveMoved() {
        movesBefore = moves;
    }

    /** Does the next sweep of an encoder move vertices? */
    public boolean isMoving() {
        return moves != movesBefore;
    }

    /** Must the next sweep move a vertex of the original, there or back? */
    public boolean isMoving(int original) {
        return isOff(moves, original) || isOff(movesBefore, original);
    }

    private static boolean isOff(int[] by, int original) {
        return by != null && (by[3 * original] | by[3 * original + 1] | by[3 * original + 2]) != 0;
    }

    /**
     * Looks up the position of a new vertex for an encoder, because positions in the original's order are scattered.
     */
    public void find(int vertex, int original) {
        int at = 3 * vertex;
        if (at == cells.length) {
            cells = ArrayGrowth.rows(cells, 3, vertex + 1, mesh.expectedVertices());
            bits = ArrayGrowth.rows(bits, 3, vertex + 1, mesh.expectedVertices());
        }
        for (int a = 0; a < 3; a++) {
            int exact = Float.floatToRawIntBits(originals[3 * original + a]);
            bits[at + a] = exact;
            cells[at + a] = points[a].cell(exact);
        }
    }

    /** Puts the wanted cells of a vertex into {@link #wanted}; a decoder's original is negative. */
    void want(int vertex, int original) {
        if (original < 0) return;
        System.arraycopy(cells, 3 * vertex, wanted, 0, 3);
        if (moves == null) return;
        int most = lattice.cellLimit() - 1;
        for (int a = 0; a < 3; a++)
            wanted[a] = (int) Math.max(-most, Math.min(most, (long) wanted[a] + moves[3 * original + a]));
    }

    /** Follows new numbers. */
    public void renumber(Renumbering numbers) {
        if (originals == null) return;
        cells = numbers.vertexRows(cells, 3);
        bits = numbers.vertexRows(bits, 3);
    }
}
