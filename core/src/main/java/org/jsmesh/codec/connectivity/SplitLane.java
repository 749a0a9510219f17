package org.jsmesh.codec.connectivity;

import java.util.Arrays;

/**
 * Passes the rings of new vertices from the coder of connectivity to the coder of positions, in the order of the splits
 * of a batch. The coder of positions may follow closely, in a thread of its own.
 */
public final class SplitLane {
    private static final int MOST_PER_RING = ConnectivityCoder.MAX_VALENCE + 3;

    /** Rings of more vertices do not tell what lies beyond their edges. */
    public static final int FEW = 6;

    private int[] parents = new int[64]; // vertices that were split
    private int[] ends = new int[64]; // of rings
    private int[] rings = new int[64 * MOST_PER_RING];
    private int[] beyond = new int[64 * FEW];
    private final boolean tellsBeyond;
    private int end;
    private int count;
    private final ThreadProgress progress = new ThreadProgress();

    /** @param tellsBeyond whether positions depend on the vertices beyond the edges of small rings */
    public SplitLane(boolean tellsBeyond) {
        this.tellsBeyond = tellsBeyond;
    }

    /** Empties the lane and makes room. */
    public void begin(int splits) {
        if (splits > parents.length) {
            parents = new int[splits];
            ends = new int[splits];
        }
        if (tellsBeyond && splits * FEW > beyond.length) beyond = new int[splits * FEW];
        end = 0;
        count = 0;
        progress.begin();
    }

    /** Starts the ring of the next split. */
    void beginRing() {
        if (end + MOST_PER_RING > rings.length) rings = Arrays.copyOf(rings, 2 * rings.length);
    }

    /** Adds a vertex to the ring; negative: outside. */
    void addToRing(int vertex) {
        rings[end++] = vertex;
    }

    /**
     * Adds the vertex beyond an edge of the ring of the next split; negative: none.
     *
     * @param number of the edge: from the ring's vertex of that number to the next one
     */
    void addBeyond(int number, int vertex) {
        beyond[FEW * count + number] = vertex;
    }

    /** Completes a split of a vertex. */
    void endSplit(int parent) {
        parents[count] = parent;
        ends[count++] = end;
    }

    /** Lets another thread see the splits so far. */
    public void publish() {
        progress.reach(count);
    }

    /** Says that no more splits follow, also after a failure. */
    public void close() {
        progress.reach(count);
        progress.end();
    }

    /** Waits for a split that another thread adds. False when it does not come. */
    public boolean await(int split, PairRunner helper) {
        return progress.await(split, helper);
    }

    public int splits() {
        return count;
    }

    public int[] rings() {
        return rings;
    }

    /** For each edge of a ring with few vertices the vertex beyond it; {@value #FEW} numbers per split. */
    public int[] beyond() {
        return beyond;
    }

    /** Are the vertices beyond the edges of a ring with so many vertices wanted? */
    boolean wantsBeyond(int vertices) {
        return tellsBeyond && vertices <= FEW;
    }

    public int ringStart(int split) {
        return split == 0 ? 0 : ends[split - 1];
    }

    public int ringEnd(int split) {
        return ends[split];
    }

    public int parent(int split) {
        return parents[split];
    }
}
