package org.jsmesh.files.gltf.draco;

import static org.jsmesh.files.gltf.draco.CornerTable.NONE;
import static org.jsmesh.files.gltf.draco.CornerTable.next;
import static org.jsmesh.files.gltf.draco.CornerTable.previous;

import org.jsmesh.files.gltf.packed.PackedException;

/**
 * The order in which the vertices of a corner table have their values in a Draco stream: along faces, depth first or
 * first to the vertices that can be predicted best (Draco specification, "Edgebreaker traversal").
 */
final class Traversal {
    private static final int PRIORITIES = 3;

    private final CornerTable table;
    private final boolean[] vertexSeen;
    private final boolean[] faceSeen;
    private final IntSequence corners = new IntSequence();
    private final int[] entryOfVertex;

    private Traversal(CornerTable table) {
        this.table = table;
        vertexSeen = new boolean[table.vertexCount()];
        faceSeen = new boolean[table.corners() / 3];
        entryOfVertex = new int[table.vertexCount()];
    }

    static ValueOrder depthFirst(CornerTable table) throws PackedException {
        Traversal traversal = new Traversal(table);
        for (int c = 0; c < table.corners(); c += 3) traversal.goDeep(c);
        return traversal.order();
    }

    static ValueOrder byDegree(CornerTable table) throws PackedException {
        Traversal traversal = new Traversal(table);
        Degrees degrees = traversal.new Degrees();
        for (int c = 0; c < table.corners(); c += 3) degrees.go(c);
        return traversal.order();
    }

    private ValueOrder order() {
        return new ValueOrder(table, corners.toArray(), entryOfVertex);
    }

    private void goDeep(int start) throws PackedException {
        if (faceSeen[start / 3]) return;
        visit(next(start));
        visit(previous(start));
        IntSequence stack = new IntSequence();
        stack.add(start);
        while (stack.size() > 0) {
            int corner = stack.get(stack.size() - 1);
            if (isSeen(corner)) stack.removeLast();
            else goAlong(corner, stack);
        }
    }

    /** Goes on while there is one way. Where there are two, both are on the stack in place of the last entry. */
    private void goAlong(int start, IntSequence stack) throws PackedException {
        int corner = start;
        while (true) {
            faceSeen[corner / 3] = true;
            int right = table.opposite(next(corner));
            int left = table.opposite(previous(corner));
            if (visit(corner) && !table.isOnBoundary(table.vertex(corner))) {
                if (right == NONE) throw new PackedException("a vertex of the Draco mesh has no whole ring of faces");
                corner = right;
                continue;
            }
            if (isSeen(right) && isSeen(left)) {
                stack.removeLast();
                return;
            }
            if (!isSeen(right) && !isSeen(left)) {
                stack.setLast(left);
                stack.add(right);
                return;
            }
            corner = isSeen(right) ? left : right;
        }
    }

    private boolean isSeen(int corner) {
        return corner == NONE || faceSeen[corner / 3];
    }

    /** Whether the vertex is new. */
    private boolean visit(int corner) throws PackedException {
        int vertex = table.vertex(corner);
        if (vertex == NONE) throw new PackedException("a corner of the Draco mesh has no vertex");
        if (vertexSeen[vertex]) return false;
        vertexSeen[vertex] = true;
        entryOfVertex[vertex] = corners.size();
        corners.add(corner);
        return true;
    }

    /** Goes to the face whose vertex is known, else to one whose vertex has two neighbours that are, else to any. */
    private final class Degrees {
        private final IntSequence[] stacks = new IntSequence[PRIORITIES];
        private final byte[] degrees = new byte[table.vertexCount()];
        private int best;

        Degrees() {
            for (int i = 0; i < PRIORITIES; i++) stacks[i] = new IntSequence();
        }

        void go(int start) throws PackedException {
            stacks[0].add(start);
            best = 0;
            visit(next(start));
            visit(previous(start));
            visit(start);
            for (int corner = pop(); corner != NONE; corner = pop()) {
                while (!isSeen(corner)) corner = step(corner);
            }
        }

        /** The next corner, or {@code NONE} when it is on a stack. */
        private int step(int corner) throws PackedException {
            faceSeen[corner / 3] = true;
            visit(corner);
            int right = table.opposite(next(corner));
            int left = table.opposite(previous(corner));
            boolean rightSeen = isSeen(right);
            if (!isSeen(left)) {
                int priority = priority(left);
                if (rightSeen && priority <= best) return left;
                push(left, priority);
            }
            if (!rightSeen) {
                int priority = priority(right);
                if (priority <= best) return right;
                push(right, priority);
            }
            return NONE;
        }

        private int priority(int corner) {
            int vertex = table.vertex(corner);
            if (vertex == NONE || vertexSeen[vertex]) return 0;
            if (degrees[vertex] > 0) return 1;
            degrees[vertex] = 1;
            return 2;
        }

        private void push(int corner, int priority) {
            stacks[priority].add(corner);
            best = Math.min(best, priority);
        }

        private int pop() {
            for (int i = best; i < PRIORITIES; i++) {
                if (stacks[i].size() > 0) {
                    best = i;
                    return stacks[i].removeLast();
                }
            }
            return NONE;
        }
    }
}
