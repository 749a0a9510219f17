package org.jsmesh.collapse;

import java.util.Arrays;
import org.jsmesh.mesh.CornerTable;

/**
 * Removes whole components that collapses cannot make any smaller, or that are down to four vertices, once they are too
 * small to matter at a level. Never removes all components, one with more than a few percent of the area, or one that
 * the bounding box needs.
 */
final class ComponentRemoval {
    /** Weight of a missing component: it is more visible than one whose shape is off. */
    private static final double VISIBILITY = 16;

    private static final double MOST_AREA = .02; // of the whole mesh
    private static final double BOX_MARGIN = .002; // of the diagonal
    private static final int FEW_VERTICES = 4;

    private final CollapseMesh mesh;
    private final UnitScale scale;
    private final double factor; // to a diagonal of 1
    private final int[] component; // of each fan vertex; null where there is but one
    private final int all;
    private int left;
    private final int[] seed; // a vertex that is there
    private final int[] vertices; // that are there
    private final int[] movable; // of these, those that a collapse could remove
    private final int[] measured; // vertices when faces and cost were measured
    private final int[] faces;
    private final float[] cost;
    private final boolean[] isKept;
    private final double mostArea;
    private double[] boxLow; // of the whole mesh
    private long[] queue = new long[0]; // candidates: cost in steps of a power of two, a hash, and the component
    private int candidates;
    private int[] faceStack = new int[64];
    private int[] vertexList = new int[64];
    private int faceCount;
    private int vertexCount;
    private final int[] seen; // per face: the visit that met it
    private int visit;

    ComponentRemoval(CollapseMesh mesh, UnitScale scale) {
        this.mesh = mesh;
        this.scale = scale;
        factor = scale.factor();
        int[] labels = joined();
        int n = number(labels);
        all = n;
        left = n;
        component = n > 1 ? labels : null;
        int size = n > 1 ? n : 0;
        seen = n > 1 ? new int[mesh.original().faces()] : null;
        seed = new int[size];
        vertices = new int[size];
        movable = new int[size];
        measured = new int[size];
        faces = new int[size];
        cost = new float[size];
        isKept = new boolean[size];
        mostArea = n > 1 ? MOST_AREA * wholeArea() : 0;
        if (n > 1) keepBox();
    }

    /** Per vertex a vertex of the same component and of no higher number. */
    private int[] joined() {
        int[] data = mesh.table().data();
        int[] parent = new int[mesh.table().vertices()];
        for (int v = 0; v < parent.length; v++) parent[v] = v;
        int end = CornerTable.STRIDE * mesh.original().faces();
        for (int c = 0; c < end; c += CornerTable.STRIDE) {
            if (!mesh.isLiveFace(CornerTable.face(c))) continue;
            int a = root(parent, data[c]);
            for (int j = c + 1; j < c + 3; j++) {
                int b = root(parent, data[j]);
                parent[Math.max(a, b)] = Math.min(a, b);
                a = Math.min(a, b);
            }
        }
        return parent;
    }

    private static int root(int[] parent, int vertex) {
        int v = vertex;
        while (parent[v] != v) {
            parent[v] = parent[parent[v]];
            v = parent[v];
        }
        return v;
    }

    /**
     * Turns what {@link #joined} gives into numbers of components, −1 for vertices without faces. Returns how many
     * there are.
     */
    private int number(int[] labels) {
        int n = 0;
        for (int v = 0; v < labels.length; v++) {
            if (labels[v] != v) labels[v] = labels[labels[v]];
            else labels[v] = mesh.table().cornerOf(v) < 0 ? -1 : n++;
        }
        return n;
    }

    private double wholeArea() {
        double sum = 0;
        for (int f = 0; f < mesh.original().faces(); f++) if (mesh.isLiveFace(f)) sum += area(f);
        return sum;
    }

    /**
     * Keeps, on each side of the bounding box, the component with most vertices among those that come close to the
     * side.
     */
    private void keepBox() {
        double[] low = new double[3];
        Arrays.fill(low, Double.POSITIVE_INFINITY);
        double[] high = new double[3];
        Arrays.fill(high, Double.NEGATIVE_INFINITY);
        for (int v = 0; v < component.length; v++) {
            if (component[v] < 0) continue;
            vertices[component[v]]++;
            for (int a = 0; a < 3; a++) {
                low[a] = Math.min(low[a], mesh.position(v, a));
                high[a] = Math.max(high[a], mesh.position(v, a));
            }
        }
        boxLow = low;
        double margin = BOX_MARGIN / factor;
        for (int side = 0; side < 6; side++) {
            int a = side % 3;
            int best = -1;
            for (int v = 0; v < component.length; v++) {
                int c = component[v];
                if (c < 0) continue;
                double x = mesh.position(v, a);
                boolean isClose = side < 3 ? x <= low[a] + margin : x >= high[a] - margin;
                if (isClose && (best < 0 || vertices[c] > vertices[best] || vertices[c] == vertices[best] && c < best))
                    best = c;
            }
            isKept[best] = true;
        }
    }

    /** Takes in which vertices may collapse, and so which components are candidates. */
    interface Collapsible {
        boolean is(int vertex);
    }

    /** Finds the candidates in what is left of the mesh. Returns how many there are. */
    int find(int[] live, int liveCount, Collapsible collapsible) {
        candidates = 0;
        if (component == null || left < 2) return 0;
        Arrays.fill(vertices, 0);
        Arrays.fill(movable, 0);
        for (int i = 0; i < liveCount; i++) {
            int c = component[live[i]];
            seed[c] = live[i];
            vertices[c]++;
            if (collapsible.is(live[i])) movable[c]++;
        }
        if (queue.length < left) queue = new long[left];
        for (int c = 0; c < all; c++) {
            if (vertices[c] == 0 || isKept[c] || vertices[c] > FEW_VERTICES && movable[c] > 0) continue;
            if (measured[c] != vertices[c]) measure(c);
            if (cost[c] == Float.POSITIVE_INFINITY) continue;
            long steps = Float.floatToRawIntBits(cost[c]) >>> 23;
            queue[candidates++] = steps << 52 | (long) (c * 0x9e3779b1 >>> 12) << 32 | c;
        }
        Arrays.sort(queue, 0, candidates);
        return candidates;
    }

    private void measure(int c) {
        measured[c] = vertices[c];
        visit++;
        walk(seed[c]);
        faces[c] = faceCount;
        double area = 0;
        for (int i = 0; i < faceCount; i++) area += area(faceStack[i]);
        double squares = 0;
        for (int a = 0; a < 3; a++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < vertexCount; i++) {
                double x = mesh.position(vertexList[i], a);
                low = Math.min(low, x);
                high = Math.max(high, x);
            }
            squares += factor * (high - low) * (factor * (high - low));
        }
        cost[c] = area > mostArea ? Float.POSITIVE_INFINITY : (float) (VISIBILITY * area * squares);
    }

    /** The cost of a component. The fewer are left, the more each stands for, and the further away is the next. */
    private float cost(int c) {
        double share = (double) all / left;
        return (float) (cost[c] * share * share);
    }

    /** Cost of the candidate that goes first. */
    float cheapest() {
        return cost((int) queue[0]);
    }

    /**
     * Removes candidates up to a cost, but at most half of all components. The pass has begun in the log.
     *
     * @param mark set to {@code pass} for the vertices that are gone; null for nobody who wants to know
     * @return faces and vertices that were removed
     */
    int[] remove(double most, SimplificationTarget target, int liveFaces, int liveCount, int[] mark, int pass) {
        int[] gone = new int[2];
        int n = 0;
        int limit = Math.min(candidates, (left + 1) / 2);
        while (n < limit && cost((int) queue[n]) <= most) {
            if (target.isReached(liveFaces - gone[0], liveCount - gone[1])) break;
            gone[0] += faces[(int) queue[n]];
            gone[1] += vertices[(int) queue[n++]];
        }
        long[] places = new long[n];
        for (int i = 0; i < n; i++) places[i] = (long) place(seed[(int) queue[i]]) << 32 | (int) queue[i];
        Arrays.sort(places); // neighbours one after the other cost fewer bytes
        for (int i = 0; i < n; i++) {
            visit++;
            walk(seed[(int) places[i]]);
            mesh.removeComponent(faceStack, faceCount, vertexList, vertexCount);
            for (int k = 0; mark != null && k < vertexCount; k++) mark[vertexList[k]] = pass;
        }
        left -= n;
        return gone;
    }

    /** Place of a vertex on a curve that visits the cells of a grid in Morton's order. */
    private int place(int vertex) {
        int place = 0;
        for (int a = 0; a < 3; a++) {
            int x = (int) (factor * (mesh.position(vertex, a) - boxLow[a]) * 1023);
            for (int bit = 0; bit < 10; bit++) place |= (x >> bit & 1) << 3 * bit + a;
        }
        return place;
    }

    /** Lists the real faces of a component and its vertices. */
    private void walk(int start) {
        int[] data = mesh.table().data();
        int real = seen.length;
        faceCount = 0;
        vertexCount = 0;
        int c = mesh.table().cornerOf(start);
        while (CornerTable.face(c) >= real) c = data[c + 4];
        meet(CornerTable.face(c));
        for (int i = 0; i < faceCount; i++) {
            int at = CornerTable.STRIDE * faceStack[i];
            for (int j = at; j < at + 3; j++) {
                int beside = CornerTable.face(data[j + 4]);
                if (beside < real && seen[beside] != visit) meet(beside);
                if (isFirst(data[j], j)) addVertex(data[j]);
            }
        }
    }

    private void meet(int face) {
        seen[face] = visit;
        if (faceCount == faceStack.length) faceStack = Arrays.copyOf(faceStack, 2 * faceCount);
        faceStack[faceCount++] = face;
    }

    /** Is this the corner that its vertex is counted by: the first real one from where walks about the vertex start? */
    private boolean isFirst(int vertex, int corner) {
        int[] data = mesh.table().data();
        int c = mesh.table().cornerOf(vertex);
        while (CornerTable.face(c) >= seen.length) c = data[c + 4];
        return c == corner;
    }

    private void addVertex(int vertex) {
        if (vertexCount == vertexList.length) vertexList = Arrays.copyOf(vertexList, 2 * vertexCount);
        vertexList[vertexCount++] = vertex;
    }

    private double area(int face) {
        int[] data = mesh.table().data();
        int at = CornerTable.STRIDE * face;
        return scale.area(data[at], data[at + 1], data[at + 2]);
    }
}
