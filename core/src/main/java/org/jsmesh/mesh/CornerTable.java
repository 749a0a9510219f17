package org.jsmesh.mesh;

import java.util.Arrays;

/**
 * Half-edge adjacency of an oriented manifold mesh with boundary, as an interleaved corner table.
 *
 * <p>Corner {@code c = 8 f + j} (j = 0, 1, 2) is corner j of face f. {@code data[c]} is its vertex, {@code data[c + 4]}
 * the corner reached by swinging counter-clockwise about that vertex into the neighbouring face. {@code data[8 f + 3]}
 * is a stamp for the user, {@code data[8 f + 7]} is spare.
 *
 * <p>Every boundary edge a→b has a <em>dummy face</em> (b, a, {@link #OUTSIDE}) behind it, so that the fan of every
 * vertex is closed and no boundary case is left in collapses and splits. All dummy faces share {@link #OUTSIDE}; nobody
 * may swing about it. It occurs at most once in the fan of any vertex.
 *
 * <p>Corner tables: Rossignac, Safonova, Szymczak 2001, '3D compression made simple'. Closing holes by a dummy vertex:
 * Touma and Gotsman 1998.
 */
public final class CornerTable {
    /** The vertex behind all boundaries. */
    public static final int OUTSIDE = -1;

    /** Ints per face. */
    public static final int STRIDE = 8;

    private static final int MOST_FACES = Sizes.MOST / STRIDE;
    private static final String WHAT = "faces and open edges";

    private int[] data;
    private int[] vertexCorner;
    private int faces;
    private int vertices;

    /**
     * Makes an empty table, which grows.
     *
     * @param faceCapacity faces to make room for, dummy ones included
     * @param vertexCapacity vertices to make room for
     */
    public CornerTable(int faceCapacity, int vertexCapacity) {
        data = new int[Sizes.of(STRIDE, Math.max(4, faceCapacity), WHAT)];
        vertexCorner = new int[Math.max(4, vertexCapacity)];
    }

    /**
     * Builds a table with its dummy faces.
     *
     * @param corners vertex of corner 3 f + j
     * @param opposites of the half-edge from corner 3 f + j to the next: the half-edge it is glued to, or negative at a
     *     boundary; at most one boundary edge may leave a vertex
     * @param faces number of faces, a third of that of corners
     * @param vertices number of vertices
     * @return the table
     */
    public static CornerTable of(int[] corners, int[] opposites, int faces, int vertices) {
        int open = 0;
        for (int h = 0; h < 3 * faces; h++) if (opposites[h] < 0) open++;
        CornerTable table = new CornerTable(faces + open, vertices);
        table.append(corners, opposites, faces, vertices);
        return table;
    }

    /**
     * Appends what {@link #of} would build: its faces, then its dummy faces; its vertices follow those that are there.
     *
     * @param corners vertex of corner 3 f + j, numbered from 0 for the new vertices
     * @param opposites as in {@link #of}
     * @param newFaces number of faces to append
     * @param newVertices number of vertices to append
     */
    public void append(int[] corners, int[] opposites, int newFaces, int newVertices) {
        int firstVertex = vertices;
        int first = STRIDE * faces;
        for (int v = 0; v < newVertices; v++) setCornerOf(addVertex(), -1);
        for (int h = 0; h < 3 * newFaces; h += 3)
            addFace(firstVertex + corners[h], firstVertex + corners[h + 1], firstVertex + corners[h + 2]);
        for (int h = 0; h < 3 * newFaces; h++) {
            int corner = first + wide(h);
            int vertex = firstVertex + corners[h];
            if (cornerOf(vertex) < 0) setCornerOf(vertex, corner);
            int swing = opposites[h % 3 == 0 ? h + 2 : h - 1];
            if (swing >= 0) setSwing(corner, first + wide(swing));
        }
        closeBoundaries(corners, opposites, newFaces, first, firstVertex);
    }

    private static int wide(int h) {
        return STRIDE * (h / 3) + h % 3;
    }

    /**
     * Puts a dummy face (b, a, OUTSIDE) behind every open edge a→b and links it with its neighbours about a, b and
     * OUTSIDE.
     */
    private void closeBoundaries(int[] corners, int[] opposites, int realFaces, int first, int firstVertex) {
        int[] behindFrom = new int[vertices - firstVertex]; // dummy face of the open edge that leaves a vertex
        for (int h = 0; h < 3 * realFaces; h++) {
            if (opposites[h] < 0)
                behindFrom[corners[h]] = addFace(vertex(next(first + wide(h))), firstVertex + corners[h], OUTSIDE);
        }
        for (int h = 0; h < 3 * realFaces; h++) {
            if (opposites[h] >= 0) continue;
            int end = next(first + wide(h));
            int dummy = STRIDE * behindFrom[corners[h]]; // corners b, a, OUTSIDE
            int ahead = STRIDE * behindFrom[vertex(end) - firstVertex]; // corners c, b, OUTSIDE
            setSwing(dummy + 1, first + wide(h)); // about a, over the edge a-b, into the real face
            setSwing(end, dummy); // about b, over the same edge, out of it
            setSwing(dummy, ahead + 1); // about b, over b-OUTSIDE
            setSwing(ahead + 2, dummy + 2); // about OUTSIDE, over the same edge
        }
    }

    /** {@return the number of faces, dummy ones included; ids are 0 .. faces − 1} */
    public int faces() {
        return faces;
    }

    /** {@return the number of vertices, without {@link #OUTSIDE}} */
    public int vertices() {
        return vertices;
    }

    /** {@return the interleaved array; it is replaced when the table grows} */
    public int[] data() {
        return data;
    }

    /**
     * Finds where walks about a vertex start.
     *
     * @param vertex id of the vertex
     * @return a corner of the vertex, or −1 when no face refers to it
     */
    public int cornerOf(int vertex) {
        return vertexCorner[vertex];
    }

    /**
     * Sets where walks about a vertex start.
     *
     * @param vertex id of the vertex
     * @param corner a corner of the vertex
     */
    public void setCornerOf(int vertex, int corner) {
        vertexCorner[vertex] = corner;
    }

    /**
     * Walks about a face.
     *
     * @param corner a corner
     * @return the next corner of its face, counter-clockwise
     */
    public static int next(int corner) {
        int isLast = corner & 2; // without a branch that no processor foretells
        return corner + 1 - isLast - (isLast >> 1);
    }

    /**
     * Walks about a face.
     *
     * @param corner a corner
     * @return the corner of its face before it, counter-clockwise
     */
    public static int previous(int corner) {
        int isLater = (corner | corner >> 1) & 1;
        return corner + 2 - 3 * isLater;
    }

    /**
     * Finds the face of a corner.
     *
     * @param corner a corner
     * @return id of the face
     */
    public static int face(int corner) {
        return corner >> 3;
    }

    /**
     * Finds the vertex of a corner.
     *
     * @param corner a corner
     * @return id of the vertex, or {@link #OUTSIDE}
     */
    public int vertex(int corner) {
        return data[corner];
    }

    /**
     * Walks about a vertex.
     *
     * @param corner a corner
     * @return the next corner counter-clockwise about the same vertex
     */
    public int swing(int corner) {
        return data[corner + 4];
    }

    /**
     * Walks about a vertex.
     *
     * @param corner a corner
     * @return the next corner clockwise about the same vertex
     */
    public int swingBack(int corner) {
        // previous(c) and the wanted corner lie on the two sides of the edge that c's face shares with its clockwise
        // neighbour
        return next(data[next(corner) + 4]);
    }

    /**
     * Tells apart the faces behind boundary edges.
     *
     * @param face id of the face
     * @return true when one of its vertices is {@link #OUTSIDE}
     */
    public boolean isDummy(int face) {
        int c = STRIDE * face;
        return data[c] == OUTSIDE || data[c + 1] == OUTSIDE || data[c + 2] == OUTSIDE;
    }

    /**
     * Counts the faces about a vertex.
     *
     * @param vertex id of the vertex
     * @return number of faces, dummy ones included
     */
    public int valence(int vertex) {
        int start = vertexCorner[vertex];
        int n = 0;
        int c = start;
        do {
            n++;
            c = data[c + 4];
        } while (c != start);
        return n;
    }

    /**
     * Appends an unconnected vertex. The caller sets its corner.
     *
     * @return id of the vertex
     */
    public int addVertex() {
        if (vertices == vertexCorner.length) reserve(faces, vertices + (vertices >> 1));
        return vertices++;
    }

    /**
     * Makes room for so many faces and vertices in all.
     *
     * @param faceCapacity faces, dummy ones included
     * @param vertexCapacity vertices
     */
    public void reserve(int faceCapacity, int vertexCapacity) {
        if (faceCapacity > data.length / STRIDE) data = Arrays.copyOf(data, Sizes.of(STRIDE, faceCapacity, WHAT));
        if (vertexCapacity > vertexCorner.length) vertexCorner = Arrays.copyOf(vertexCorner, vertexCapacity);
    }

    /** {@return the number of faces that there is room for} */
    public int faceCapacity() {
        return data.length / STRIDE;
    }

    /** {@return the number of vertices that there is room for} */
    public int vertexCapacity() {
        return vertexCorner.length;
    }

    /**
     * Appends a face. The caller sets its swings.
     *
     * @param a vertex of its corner 0, or {@link #OUTSIDE}
     * @param b vertex of its corner 1, or {@link #OUTSIDE}
     * @param c vertex of its corner 2, or {@link #OUTSIDE}
     * @return id of the face
     */
    public int addFace(int a, int b, int c) {
        int at = STRIDE * faces;
        if (at > data.length - STRIDE)
            reserve(Math.max(faces + 1, Math.min(faces + (faces >> 1), MOST_FACES)), vertices);
        data[at] = a;
        data[at + 1] = b;
        data[at + 2] = c;
        return faces++;
    }

    /**
     * Sets what {@link #swing} answers.
     *
     * @param corner a corner
     * @param to the next corner counter-clockwise about the same vertex
     */
    public void setSwing(int corner, int to) {
        data[corner + 4] = to;
    }
}
