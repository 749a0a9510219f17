package org.jsmesh.mesh;

import java.util.Arrays;

/**
 * The corner table of any mesh, made manifold by cutting. Edges that are not shared by exactly two faces of opposite
 * direction become boundaries. A vertex whose faces form several fans becomes several <em>fan vertices</em>. Degenerate
 * faces stand alone.
 *
 * <p>Faces keep their ids; dummy faces follow. The first fan of a mesh vertex keeps the vertex' id, further ones are
 * appended. Between two fan vertices there is at most one edge. Gueziec, Taubin, Lazarus, Horn 2001, 'Cutting and
 * stitching: converting sets of polygons to manifold surfaces'.
 */
public final class ManifoldCut {
    /** Most edges of one vertex that are compared each with each; more are sorted. */
    private static final int FEW = 16;

    /** Rounds of cutting out faces, each because of the last, after which all of them stand alone. */
    private static final int MOST_ROUNDS = 64;

    private final int vertices;
    private final int corners;
    private final int[] opposite; // of half-edge 3f+j (from corner j to corner j+1), or -1
    private final int[] fan; // fan vertex of corner 3f+j; until it has one, the complement of its mesh vertex
    private int fans;
    private int[] vertexOf;
    private CornerTable table; // when somebody has asked

    /**
     * Cuts a mesh.
     *
     * @param mesh any mesh; it stays as it is
     */
    public ManifoldCut(Mesh mesh) {
        vertices = mesh.vertices();
        corners = 3 * mesh.faces();
        opposite = new int[corners];
        fan = new int[corners];
        int[] wedges = mesh.faceWedges();
        int[] wedgeVertices = mesh.wedgeVertices();
        for (int c = 0; c < corners; c++) fan[c] = ~wedgeVertices[wedges[c]];
        Arrays.fill(opposite, -1);
        matchEdges(edges());
        assignFans();
        for (int round = 1; isolateRepeatedEdges(); round++) {
            if (round == MOST_ROUNDS) Arrays.fill(opposite, -1);
            for (int c = 0; c < corners; c++) fan[c] = ~vertexOf[fan[c]];
            assignFans();
        }
    }

    /** {@return the adjacency of the mesh that was cut; shared, not copied} */
    public CornerTable table() {
        if (table == null) table = CornerTable.of(fan, opposite, corners / 3, fans);
        return table;
    }

    /** {@return whether no face has a neighbour} */
    public boolean isApart() {
        for (int other : opposite) if (other >= 0) return false;
        return true;
    }

    /** {@return the fan vertex of corner 3 f + j of the mesh that was cut; shared, not copied} */
    public int[] fans() {
        return fan;
    }

    /** {@return the mesh vertex of each fan vertex; unreferenced vertices keep their id and have no corner (−1)} */
    public int[] vertexOf() {
        return vertexOf;
    }

    /** Mesh vertex of a corner that has no fan yet. */
    private int vertex(int corner) {
        return ~fan[corner];
    }

    private static int next(int corner) {
        return corner % 3 == 2 ? corner - 2 : corner + 1;
    }

    private static int previous(int corner) {
        return corner % 3 == 0 ? corner + 2 : corner - 1;
    }

    private static boolean isDegenerate(int a, int b, int c) {
        return a == b || b == c || c == a;
    }

    /** The half-edges of faces that are not degenerate, in buckets of the smaller of their vertices: a few each. */
    private Buckets edges() {
        Buckets edges = new Buckets(vertices);
        for (int f = 0; f < corners; f += 3) {
            int a = vertex(f);
            int b = vertex(f + 1);
            int c = vertex(f + 2);
            if (isDegenerate(a, b, c)) continue;
            edges.count(Math.min(a, b));
            edges.count(Math.min(b, c));
            edges.count(Math.min(c, a));
        }
        edges.lay();
        for (int f = 0; f < corners; f += 3) {
            int a = vertex(f);
            int b = vertex(f + 1);
            int c = vertex(f + 2);
            if (isDegenerate(a, b, c)) continue;
            edges.add(Math.min(a, b), f);
            edges.add(Math.min(b, c), f + 1);
            edges.add(Math.min(c, a), f + 2);
        }
        return edges;
    }

    /** Glues two half-edges that share an edge and have opposite directions, where there are no others. */
    private void matchEdges(Buckets edges) {
        long[] sorted = new long[FEW];
        for (int v = 0; v < vertices; v++) {
            int start = edges.start(v);
            int count = edges.end(v) - start;
            if (count > sorted.length) sorted = new long[2 * count];
            for (int i = 0; i < count; i++) { // by the other vertex
                int h = edges.items()[start + i];
                long key = (long) Math.max(vertex(h), vertex(next(h))) << 32 | h;
                int j = i;
                if (count <= FEW) for (; j > 0 && sorted[j - 1] > key; j--) sorted[j] = sorted[j - 1];
                sorted[j] = key;
            }
            if (count > FEW) Arrays.sort(sorted, 0, count);
            for (int i = 0, j; i < count; i = j) {
                for (j = i + 1; j < count && sorted[j] >> 32 == sorted[i] >> 32; ) j++;
                int h = (int) sorted[i];
                int other = (int) sorted[j - 1];
                if (j == i + 2 && vertex(h) != vertex(other)) {
                    opposite[h] = other;
                    opposite[other] = h;
                }
            }
        }
    }

    private void assignFans() {
        boolean[] seen = new boolean[vertices];
        vertexOf = new int[vertices + 16];
        for (int v = 0; v < vertices; v++) vertexOf[v] = v;
        fans = vertices;
        for (int start = 0; start < corners; start++) {
            if (fan[start] >= 0) continue;
            int v = vertex(start);
            int id = v;
            if (seen[v]) {
                if (fans == vertexOf.length) vertexOf = Arrays.copyOf(vertexOf, fans + (fans >> 1));
                vertexOf[fans] = v;
                id = fans++;
            }
            seen[v] = true;
            int c = start;
            while (c >= 0 && fan[c] < 0) { // counter-clockwise
                fan[c] = id;
                c = opposite[previous(c)];
            }
            if (c >= 0) continue; // closed fan
            for (c = opposite[start]; c >= 0; c = opposite[c]) { // clockwise
                c = next(c);
                fan[c] = id;
            }
        }
        if (fans < vertexOf.length) vertexOf = Arrays.copyOf(vertexOf, fans);
    }

    /** Cuts out faces so that no two open edges join the same fan vertices. True when something was cut. */
    private boolean isolateRepeatedEdges() {
        EdgeMap edges = new EdgeMap(64);
        boolean cut = false;
        for (int h = 0; h < corners; h++) {
            if (opposite[h] >= 0) continue;
            int first = h - h % 3;
            if (isDegenerate(vertexOf[fan[first]], vertexOf[fan[first + 1]], vertexOf[fan[first + 2]])) continue;
            boolean alone = opposite[first] < 0 && opposite[first + 1] < 0 && opposite[first + 2] < 0;
            if (edges.put(fan[h], fan[next(h)], h) >= 0 && !alone) {
                for (int k = first; k < first + 3; k++) {
                    if (opposite[k] >= 0) opposite[opposite[k]] = -1;
                    opposite[k] = -1;
                }
                cut = true;
            }
        }
        return cut;
    }
}
