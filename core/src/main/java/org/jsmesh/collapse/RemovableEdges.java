package org.jsmesh.collapse;

import java.util.Arrays;
import java.util.function.IntPredicate;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.TooLargeException;

/**
 * The edges that may be removed in a pass of a level (sections 3 and 4.1 of Chen and Nishita 2002). Base edges have a
 * weight above the level's threshold. The ends of sharp edges (corner vertices) and of base edges are un-removable; all
 * other edges with a removable end form a priority queue, lightest first.
 *
 * <p>Edges of the same weight are shuffled, in the same way every time. In the order of their numbers, flat regions
 * would be removed along long chains of vertices, where each has to wait for the one before.
 */
public final class RemovableEdges {
    private static final int SHUFFLE = 0x9E3779B1;

    /** Times {@link #SHUFFLE} it is 1. */
    private static final int UNSHUFFLE = 0x0E8B2F51;

    private final ScalarAttributes attributes;
    private final CornerTable table;
    private final int faces;
    private final IntPredicate live;
    private final boolean[] locked;
    private final int[] basePass; // pass in which a vertex was last the end of a base edge
    private int pass;
    private long[] queue = new long[512];
    private int[] ends = new int[1024];
    private int size;

    /**
     * @param faces number of real faces, which come first
     * @param live tells which faces no collapse has removed
     */
    public RemovableEdges(ScalarAttributes attributes, CornerTable table, int faces, IntPredicate live) {
        this.attributes = attributes;
        this.table = table;
        this.faces = faces;
        this.live = live;
        locked = new boolean[table.vertices()];
        basePass = new int[table.vertices()];
        for (int f = 0; f < faces; f++) {
            for (int c = CornerTable.STRIDE * f; c < CornerTable.STRIDE * f + 3; c++) {
                if (!attributes.isSharp(c)) continue;
                lock(table.vertex(c));
                lock(table.vertex(CornerTable.previous(c)));
            }
        }
    }

    /** Makes a vertex un-removable for good, like a corner vertex. */
    public void lock(int vertex) {
        locked[vertex] = true;
    }

    /** May this vertex be removed at some level? */
    public boolean isLocked(int vertex) {
        return locked[vertex];
    }

    /** Finds the base edges of the mesh as it is now, and puts the others in the queue. */
    public void find(double threshold) {
        pass++;
        size = 0;
        for (int f = 0; f < faces; f++) {
            if (!live.test(f)) continue;
            for (int c = CornerTable.STRIDE * f; c < CornerTable.STRIDE * f + 3; c++) {
                int a = table.vertex(c);
                int b = table.vertex(CornerTable.previous(c));
                if (a > b || locked[a] && locked[b]) continue; // every edge is met from both ends
                float weight = attributes.weight(c);
                if (weight > threshold) {
                    basePass[a] = pass;
                    basePass[b] = pass;
                } else {
                    add(a, b, weight);
                }
            }
        }
        Arrays.sort(queue, 0, size);
    }

    private void add(int a, int b, float weight) {
        if (size == queue.length) {
            if (size == Sizes.MOST / 2) throw new TooLargeException(size + 1L, "edges", size);
            queue = Arrays.copyOf(queue, Math.min(Sizes.MOST / 2, 2 * size));
            ends = Arrays.copyOf(ends, 2 * queue.length);
        }
        ends[2 * size] = a;
        ends[2 * size + 1] = b;
        queue[size] = (long) Float.floatToRawIntBits(weight) << 32
                | Integer.toUnsignedLong(size * SHUFFLE); // weights are ≥ 0
        size++;
    }

    /** Number of edges in the queue. Some have no removable end. */
    public int size() {
        return size;
    }

    /** One end of the edge at a place in the queue. */
    public int end(int place) {
        return ends[2 * ((int) queue[place] * UNSHUFFLE)];
    }

    /** The other end. */
    public int otherEnd(int place) {
        return ends[2 * ((int) queue[place] * UNSHUFFLE) + 1];
    }

    /** May this vertex be removed in this pass? */
    public boolean isRemovable(int vertex) {
        return !locked[vertex] && basePass[vertex] != pass;
    }
}
