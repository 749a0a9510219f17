package org.jsmesh.mesh;

import java.util.Arrays;

/**
 * The corner table of any mesh, made manifold by cutting: edges that are not shared by exactly two faces of opposite direction become
 * boundaries, a vertex whose faces form several fans becomes several <em>fan vertices</em>, and degenerate faces stand alone.
 *
 * <p>Faces keep their ids; dummy faces follow. The first fan of a mesh vertex keeps the vertex' id, further ones are appended. Between two fan
 * vertices there is at most one edge. Gueziec, Taubin, Lazarus, Horn 2001, 'Cutting and stitching: converting sets of polygons to manifold surfaces'.
 */
public final class ManifoldCut {
    private final Mesh mesh;
    private final int corners;
    private final int[] opposite; // of half-edge 3f+j (from corner j to corner j+1), or -1
    private final int[] fan; // fan vertex of corner 3f+j
    private int fans;
    private int[] vertexOf;
    private CornerTable table;

    public ManifoldCut(Mesh mesh) {
        this.mesh = mesh;
        corners = 3 * mesh.faces();
        opposite = new int[corners];
        fan = new int[corners];
        matchEdges();
        do {
            assignFans();
        } while (isolateRepeatedEdges());
        table = CornerTable.of(fan, opposite, corners / 3, fans);
    }

    public CornerTable table() {
        return table;
    }

    /** The mesh vertex of each fan vertex; unreferenced vertices keep their id and have no corner (−1). */
    public int[] vertexOf() {
        return vertexOf;
    }

    private int vertex(int corner) {
        return mesh.wedgeVertices()[mesh.faceWedges()[corner]];
    }

    private static int next(int corner) {
        return corner % 3 == 2 ? corner - 2 : corner + 1;
    }

    private static int previous(int corner) {
        return corner % 3 == 0 ? corner + 2 : corner - 1;
    }

    private void matchEdges() {
        Arrays.fill(opposite, -1);
        EdgeMap edges = new EdgeMap(corners);
        int[] sameEdge = new int[corners]; // chain of the half-edges of one undirected edge
        for (int f = 0; f < corners; f += 3) {
            if (isDegenerate(f)) continue;
            for (int h = f; h < f + 3; h++) sameEdge[h] = edges.put(vertex(h), vertex(next(h)), h);
        }
        for (int h = 0; h < corners; h++) {
            if (isDegenerate(h - h % 3) || edges.get(vertex(h), vertex(next(h))) != h)
                continue; // only the chain's head
            int other = sameEdge[h];
            if (other >= 0 && sameEdge[other] < 0 && vertex(other) == vertex(next(h))) {
                opposite[h] = other;
                opposite[other] = h;
            }
        }
    }

    private boolean isDegenerate(int firstCorner) {
        int a = vertex(firstCorner);
        int b = vertex(firstCorner + 1);
        int c = vertex(firstCorner + 2);
        return a == b || b == c || c == a;
    }

    private void assignFans() {
        int vertices = mesh.vertices();
        boolean[] seen = new boolean[vertices];
        vertexOf = new int[vertices + 16];
        for (int v = 0; v < vertices; v++) vertexOf[v] = v;
        fans = vertices;
        Arrays.fill(fan, -1);
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
        vertexOf = Arrays.copyOf(vertexOf, fans);
    }

    /** Cuts out faces so that no two open edges join the same fan vertices. True when something was cut. */
    private boolean isolateRepeatedEdges() {
        EdgeMap edges = new EdgeMap(64);
        boolean cut = false;
        for (int h = 0; h < corners; h++) {
            if (opposite[h] >= 0 || isDegenerate(h - h % 3)) continue;
            int first = h - h % 3;
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
