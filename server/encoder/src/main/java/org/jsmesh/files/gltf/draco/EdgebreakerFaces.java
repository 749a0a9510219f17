package org.jsmesh.files.gltf.draco;

import static org.jsmesh.files.gltf.draco.CornerTable.NONE;
import static org.jsmesh.files.gltf.draco.CornerTable.next;
import static org.jsmesh.files.gltf.draco.CornerTable.previous;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.jsmesh.files.gltf.packed.PackedException;

/**
 * Puts the faces of a mesh together, the last one first (Draco specification, "Edgebreaker decoder"; Isenburg and
 * Snoeyink: Spirale Reversi, 2000). Each symbol adds a face to the edge opposite to the active corner.
 */
final class EdgebreakerFaces {
    /** A handle: when the symbol {@code source} is reached, one of its edges waits for the symbol {@code split}. */
    record Split(int source, int split, boolean right) {}

    /** A vertex that was merged is looked at again when it is merged again; real meshes stay far below this. */
    private static final long STEPS_PER_CORNER = 256;

    private final CornerTable table;
    private final EdgebreakerSymbols symbols;
    private final int symbolCount;
    private final ArrayDeque<Split> splits;
    private final Map<Integer, Integer> waiting = new HashMap<>();
    private final IntSequence active = new IntSequence();
    private int faces;
    /** Of vertices that are not within the surface. */
    final boolean[] boundary;

    private final IntSequence merged = new IntSequence();
    private long stepsLeft;

    EdgebreakerFaces(
            CornerTable table,
            EdgebreakerSymbols symbols,
            int symbolCount,
            int mostVertices,
            ArrayDeque<Split> splits) {
        this.table = table;
        this.symbols = symbols;
        this.symbolCount = symbolCount;
        this.splits = splits;
        boundary = new boolean[mostVertices];
        Arrays.fill(boundary, true);
        stepsLeft = STEPS_PER_CORNER * table.corners();
    }

    void decode(RansBits startFaces) throws PackedException {
        for (int i = 0; i < symbolCount; i++) {
            int symbol = symbols.next();
            int corner = 3 * faces++;
            switch (symbol) {
                case EdgebreakerSymbols.C -> close(corner);
                case EdgebreakerSymbols.R -> extend(corner, corner + 2, corner, corner + 1);
                case EdgebreakerSymbols.L -> extend(corner, corner + 1, corner + 2, corner);
                case EdgebreakerSymbols.S -> join(corner, waiting.get(i));
                default -> begin(corner);
            }
            symbols.reached(top());
            if (symbol > EdgebreakerSymbols.S) takeSplits(symbolCount - i - 1);
        }
        while (active.size() > 0) {
            int corner = pop();
            if (startFaces.next()) fill(corner);
        }
        if (3 * faces != table.corners()) throw damaged();
        requireRings();
    }

    /** C: a face between two edges at a vertex, which is within the surface now. */
    private void close(int corner) throws PackedException {
        int a = top();
        int tip = table.vertex(next(a));
        int b = next(table.leftMost(tip));
        requireFree(a, b);
        int before = table.vertex(previous(a));
        int after = table.vertex(next(b));
        if (tip == before || tip == after) throw damaged();
        table.connect(a, corner + 1);
        table.connect(b, corner + 2);
        table.setVertex(corner, tip);
        table.setVertex(corner + 1, after);
        setLeftMost(corner + 2, before);
        boundary[tip] = false;
        active.setLast(corner);
    }

    /** R and L: a face with a new vertex. */
    private void extend(int corner, int tip, int right, int left) throws PackedException {
        int a = top();
        if (table.opposite(a) != NONE) throw damaged();
        table.connect(tip, a);
        table.setVertex(tip, table.addVertex(tip));
        setLeftMost(right, table.vertex(previous(a)));
        table.setVertex(left, table.vertex(next(a)));
        active.setLast(corner);
    }

    /** S: a face that joins two parts. One of their vertices is the same as another and is removed. */
    private void join(int corner, Integer waited) throws PackedException {
        int b = pop();
        if (waited != null) active.add(waited);
        int a = top();
        requireFree(a, b);
        table.connect(a, corner + 2);
        table.connect(b, corner + 1);
        int kept = table.vertex(previous(a));
        table.setVertex(corner, kept);
        table.setVertex(corner + 1, table.vertex(next(a)));
        setLeftMost(corner + 2, table.vertex(previous(b)));
        int first = next(b);
        int removed = table.vertex(first);
        if (kept == removed) throw damaged();
        symbols.merge(kept, removed);
        table.setLeftMost(kept, table.leftMost(removed));
        for (int c = first; c != NONE; ) {
            if (--stepsLeft < 0) throw damaged();
            table.setVertex(c, kept);
            c = table.swingLeft(c);
            if (c == first) throw damaged();
        }
        table.setLeftMost(removed, NONE);
        merged.add(removed);
        active.setLast(corner);
    }

    /** E: a face with three new vertices. */
    private void begin(int corner) throws PackedException {
        for (int c = corner; c < corner + 3; c++) table.setVertex(c, table.addVertex(c));
        active.add(corner);
    }

    /** A face that closes a hole of three edges, where the traversal began. */
    private void fill(int a) throws PackedException {
        if (3 * faces >= table.corners()) throw damaged();
        int n = table.vertex(next(a));
        int b = next(table.leftMost(n));
        requireFree(a, b);
        int x = table.vertex(next(b));
        int c = next(table.leftMost(x));
        requireFree(a, c);
        requireFree(b, c);
        int p = table.vertex(next(c));
        int corner = 3 * faces++;
        table.connect(corner, a);
        table.connect(corner + 1, b);
        table.connect(corner + 2, c);
        table.setVertex(corner, x);
        table.setVertex(corner + 1, p);
        table.setVertex(corner + 2, n);
        boundary[x] = false;
        boundary[p] = false;
        boundary[n] = false;
    }

    private void takeSplits(int symbol) throws PackedException {
        while (!splits.isEmpty() && splits.peekLast().source() >= symbol) {
            Split split = splits.removeLast();
            if (split.source() > symbol) throw damaged();
            int corner = split.right() ? next(top()) : previous(top());
            waiting.put(symbolCount - split.split() - 1, corner);
        }
    }

    /** Moves the last vertices into the places of those that were merged. Returns how many there are then. */
    int removeMerged() throws PackedException {
        int count = table.vertexCount();
        for (int i = 0; i < merged.size(); i++) {
            int gap = merged.get(i);
            while (count > 0 && table.leftMost(count - 1) == NONE) count--;
            int last = count - 1;
            if (last < gap) continue;
            int start = table.leftMost(last);
            int c = start;
            do {
                table.setVertex(c, gap);
                c = table.swingLeft(c);
            } while (c != NONE && c != start);
            if (c == NONE) {
                for (c = table.swingRight(start); c != NONE; c = table.swingRight(c)) table.setVertex(c, gap);
            }
            table.setLeftMost(gap, start);
            table.setLeftMost(last, NONE);
            count--;
        }
        return count;
    }

    /** Each edge has the same vertices on both sides, so that all corners around a vertex are its own. */
    private void requireRings() throws PackedException {
        for (int c = 0; c < table.corners(); c++) {
            int across = table.opposite(c);
            boolean right = table.vertex(c) != NONE
                    && (across == NONE
                            || table.vertex(next(c)) == table.vertex(previous(across))
                                    && table.vertex(previous(c)) == table.vertex(next(across)));
            if (!right) throw damaged();
        }
    }

    private void setLeftMost(int corner, int vertex) {
        table.setVertex(corner, vertex);
        table.setLeftMost(vertex, corner);
    }

    private void requireFree(int a, int b) throws PackedException {
        if (b == NONE || a == b || table.opposite(a) != NONE || table.opposite(b) != NONE) throw damaged();
    }

    private int top() throws PackedException {
        if (active.size() == 0) throw damaged();
        return active.get(active.size() - 1);
    }

    private int pop() throws PackedException {
        if (active.size() == 0) throw damaged();
        return active.removeLast();
    }

    private static PackedException damaged() {
        return new PackedException("the faces of the Draco mesh do not fit together");
    }
}
