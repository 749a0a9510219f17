package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedException;

/** A corner table that is cut open along the seams of an attribute, and has a vertex for each side of a seam. */
final class SeamTable extends CornerTable {
    private final CornerTable whole;
    private final boolean[] seamEdge;
    private final boolean[] seamVertex;

    SeamTable(CornerTable whole) {
        super(whole, whole.corners());
        this.whole = whole;
        seamEdge = new boolean[whole.corners()];
        seamVertex = new boolean[whole.vertexCount()];
    }

    @Override
    int opposite(int corner) {
        return corner == NONE || seamEdge[corner] ? NONE : super.opposite(corner);
    }

    /** Cuts the edge opposite to a corner. */
    void cut(int corner) {
        seamEdge[corner] = true;
        int across = whole.opposite(corner);
        if (across != NONE) seamEdge[across] = true;
        seamVertex[whole.vertex(next(corner))] = true;
        seamVertex[whole.vertex(previous(corner))] = true;
    }

    boolean isOnSeam(int corner) {
        return seamVertex[whole.vertex(corner)];
    }

    /** To be called once, when all edges are cut. */
    void numberVertices() throws PackedException {
        for (int v = 0; v < whole.vertexCount(); v++) {
            int start = whole.leftMost(v);
            if (start == NONE) continue;
            int first = start;
            if (seamVertex[v]) {
                for (int c = swingLeft(start); c != NONE; c = swingLeft(c)) {
                    if (c == start) throw new PackedException("a seam of the Draco mesh does not end");
                    first = c;
                }
            }
            int vertex = addVertex(first);
            setVertex(first, vertex);
            for (int c = whole.swingRight(first); c != NONE && c != first; c = whole.swingRight(c)) {
                if (seamEdge[next(c)]) vertex = addVertex(c);
                setVertex(c, vertex);
            }
        }
    }
}
