package org.jsmesh.files.gltf.draco;

import java.util.Arrays;
import org.jsmesh.files.gltf.packed.PackedException;

/**
 * Corners of triangles (three for each, in order): the vertex at each, and the corner across the opposite edge. -1 is
 * no corner and no vertex. Swinging goes around the vertex of a corner.
 */
class CornerTable {
    static final int NONE = -1;

    private final int[] opposites;
    private final int[] vertices;
    private final int[] leftMost;
    private int vertexCount;

    CornerTable(int faces, int mostVertices) {
        this(new int[3 * faces], mostVertices);
        Arrays.fill(opposites, NONE);
    }

    /** A table with the same edges as another, and with vertices of its own. */
    CornerTable(CornerTable edges, int mostVertices) {
        this(edges.opposites, mostVertices);
    }

    private CornerTable(int[] opposites, int mostVertices) {
        this.opposites = opposites;
        vertices = new int[opposites.length];
        leftMost = new int[mostVertices];
        Arrays.fill(vertices, NONE);
    }

    static int next(int corner) {
        return corner == NONE ? NONE : corner % 3 == 2 ? corner - 2 : corner + 1;
    }

    static int previous(int corner) {
        return corner == NONE ? NONE : corner % 3 == 0 ? corner + 2 : corner - 1;
    }

    int corners() {
        return vertices.length;
    }

    int vertexCount() {
        return vertexCount;
    }

    int opposite(int corner) {
        return corner == NONE ? NONE : opposites[corner];
    }

    int vertex(int corner) {
        return vertices[corner];
    }

    /** The corner that has no other to its left; any corner of a vertex within the surface. */
    int leftMost(int vertex) {
        return leftMost[vertex];
    }

    final int swingLeft(int corner) {
        return next(opposite(next(corner)));
    }

    final int swingRight(int corner) {
        return previous(opposite(previous(corner)));
    }

    final boolean isOnBoundary(int vertex) {
        return swingLeft(leftMost(vertex)) == NONE;
    }

    final int addVertex(int leftMostCorner) throws PackedException {
        if (vertexCount == leftMost.length) throw new PackedException("the Draco mesh has more vertices than it says");
        leftMost[vertexCount] = leftMostCorner;
        return vertexCount++;
    }

    final void setVertex(int corner, int vertex) {
        vertices[corner] = vertex;
    }

    final void setLeftMost(int vertex, int corner) {
        leftMost[vertex] = corner;
    }

    final void connect(int a, int b) {
        opposites[a] = b;
        opposites[b] = a;
    }
}
