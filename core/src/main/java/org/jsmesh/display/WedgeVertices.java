package org.jsmesh.display;

import java.util.Arrays;
import org.jsmesh.mesh.GrowingMesh;

/**
 * The render vertices of wedges: one, and where creases meet at a wedge one for each side. What a wedge needs no more
 * is given to another one, but not in the same step: faces may still be drawn with it while the step is on its way.
 */
final class WedgeVertices {
    static final int NONE = -1;

    private int[] first = new int[0]; // of each wedge, or −1
    private int[] next = new int[64]; // of the same wedge, or of those to spare, or −1
    private int[] takenIn = new int[64]; // step in which a wedge has taken it
    private int size;
    private int step;
    private int spare = NONE;
    private int givenUp = NONE; // in this step

    /** Makes room for so many wedges. */
    void reserve(int wedges) {
        int before = first.length;
        if (wedges <= before) return;
        first = Arrays.copyOf(first, wedges + wedges / 2);
        Arrays.fill(first, before, first.length, NONE);
    }

    void beginStep() {
        step++;
        while (givenUp != NONE) {
            int vertex = givenUp;
            givenUp = next[vertex];
            next[vertex] = spare;
            spare = vertex;
        }
    }

    /** Render vertices in all. */
    int size() {
        return size;
    }

    /** The first render vertex of a wedge, or {@link #NONE}. */
    int first(int wedge) {
        return first[wedge];
    }

    /** Does each wedge of some corners, as {@link GrowingMesh#corners} gives them, have one render vertex? */
    boolean areSingle(int[] corners, int size) {
        for (int i = 2; i < size; i += GrowingMesh.CORNER) {
            int vertex = first[corners[i]];
            if (vertex == NONE || next[vertex] != NONE) return false;
        }
        return true;
    }

    /** The next render vertex of the same wedge, or {@link #NONE}. */
    int next(int vertex) {
        return next[vertex];
    }

    /** Has the wedge taken this render vertex in this step? */
    boolean isTaken(int vertex) {
        return takenIn[vertex] == step;
    }

    void take(int vertex) {
        takenIn[vertex] = step;
    }

    /** Gives a wedge one more render vertex, which is taken. */
    int add(int wedge) {
        int vertex = spare;
        if (vertex == NONE) {
            vertex = size++;
            if (vertex == next.length) {
                next = Arrays.copyOf(next, 2 * vertex);
                takenIn = Arrays.copyOf(takenIn, 2 * vertex);
            }
        } else {
            spare = next[vertex];
        }
        next[vertex] = first[wedge];
        first[wedge] = vertex;
        take(vertex);
        return vertex;
    }

    /** Takes from a wedge the render vertices that it has not taken in this step. */
    void giveUpOthers(int wedge) {
        int kept = NONE;
        int vertex = first[wedge];
        if (next[vertex] == NONE) return; // the only one is taken
        while (vertex != NONE) {
            int after = next[vertex];
            if (isTaken(vertex)) {
                kept = vertex;
            } else {
                if (kept == NONE) first[wedge] = after;
                else next[kept] = after;
                next[vertex] = givenUp;
                givenUp = vertex;
            }
            vertex = after;
        }
    }
}
