package org.jsmesh.codec.lod;

import java.util.Arrays;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Sizes;

/**
 * The mesh that encoder and decoder share while splits are coded. It has the corner table of fan vertices, the position
 * of each fan vertex as cells of the lattice's grid, and, where the mesh has channels or materials, the wedge of every
 * corner.
 */
public final class LodMesh {
    private CornerTable table;
    /** Corners have wedges of their own; else the wedge of a corner is its vertex. */
    public final boolean hasChannels;

    public final boolean hasMaterials;
    private int[] places = new int[4 * 64];
    private int[] vertexOf; // mesh vertex of each fan vertex; null without stitches, when they are the same
    private int[] firstFan; // of each mesh vertex; null likewise
    private int[] nextFan = new int[0]; // further fan vertex of the same mesh vertex, or 0
    private int fans;
    private int vertices;
    private int[] positionBits = new int[3 * 64]; // per mesh vertex
    private int[] cornerWedges; // 4 per face: three wedges and the material; -1 in dummy faces
    private int[] wedgeVertices = new int[64];
    private int wedges;
    private int[] lastWedge; // of each mesh vertex, or −1; null without stitches or channels
    private int[] wedgeBefore; // of the same mesh vertex, or −1; null likewise
    private int realFaces;
    private final int expectedVertices;
    private final int expectedFans;
    private final int expectedFaces;
    private boolean isSeparate;
    private LodChanges changes; // null when nobody asks

    /**
     * A mesh that is expected to get so many vertices and faces; with stitches, vertices may have several fans.
     *
     * @param fans expected fan vertices; an encoder knows them, a decoder gives the vertices
     * @param faces expected faces; an encoder counts dummy ones, a decoder does not know of these
     */
    public LodMesh(boolean hasChannels, boolean hasMaterials, boolean hasStitches, int vertices, int fans, int faces) {
        expectedVertices = vertices;
        expectedFans = fans;
        expectedFaces = faces;
        vertexOf = hasStitches ? new int[64] : null;
        firstFan = hasStitches ? new int[64] : null;
        lastWedge = hasStitches && hasChannels ? new int[64] : null;
        wedgeBefore = hasStitches && hasChannels ? new int[64] : null;
        this.hasChannels = hasChannels;
        this.hasMaterials = hasMaterials;
        cornerWedges = new int[0];
    }

    /**
     * Makes the mesh do without a table, for an encoder of triangles that have no neighbours and neither channels nor
     * materials: face f has the fan vertices 3 f, 3 f + 1 and 3 f + 2.
     */
    public void setSeparate() {
        isSeparate = true;
    }

    /** Is there no table, because no face has a neighbour? */
    public boolean isSeparate() {
        return isSeparate;
    }

    /** Begins to note changes; before the base. */
    public LodChanges noteChanges() {
        changes = new LodChanges();
        return changes;
    }

    /** Where changes are noted; null when nobody asks. */
    public LodChanges changes() {
        return changes;
    }

    /** Notes which fan vertex a new one was split from. */
    public void noteSplit(int fan, int parent) {
        if (changes != null) changes.split(fan, parent);
    }

    /** The table of the base, to be refined. */
    public void setTable(CornerTable base) {
        table = base;
    }

    public CornerTable table() {
        return table;
    }

    /** Faces that are there, dummy ones of the table included. */
    public int allFaces() {
        return table == null ? realFaces : table.faces();
    }

    public int fans() {
        return fans;
    }

    public int vertices() {
        return vertices;
    }

    public int wedges() {
        return hasChannels ? wedges : vertices;
    }

    /** Faces that are no dummies. */
    public int realFaces() {
        return realFaces;
    }

    public void countFaces(int added) {
        realFaces += added;
    }

    /**
     * Four per fan vertex: its position in cells, and a tag for the coder of positions. They share a row because they
     * are used together.
     */
    public int[] places() {
        return places;
    }

    /** The first fan vertex of a mesh vertex. */
    public int firstFan(int vertex) {
        return firstFan == null ? vertex : firstFan[vertex];
    }

    /** Another fan vertex of the same mesh vertex, or 0 after the last. */
    public int nextFan(int fan) {
        return fan < nextFan.length ? nextFan[fan] : 0;
    }

    public int vertexOf(int fan) {
        return vertexOf == null ? fan : vertexOf[fan];
    }

    public int[] positionBits() {
        return positionBits;
    }

    /**
     * Gives vertices and faces new numbers. Only for meshes without stitches, where fan vertices are vertices.
     *
     * @param isExact whether position bits are of use yet
     */
    public void renumber(Renumbering numbers, boolean isExact) {
        numbers.apply(table);
        places = numbers.vertexRows(places, 4);
        if (isExact) positionBits = numbers.vertexRows(positionBits, 3);
        if (hasChannels || hasMaterials) cornerWedges = numbers.faceRows(cornerWedges, 4);
        for (int w = 0; w < wedges; w++) wedgeVertices[w] = numbers.newVertex[wedgeVertices[w]];
        if (changes != null) changes.renumber(numbers);
    }

    /** Appends a mesh vertex whose position follows. */
    public int addVertex() {
        if (3 * vertices == positionBits.length)
            positionBits = ArrayGrowth.rows(positionBits, 3, vertices + 1, expectedVertices);
        if (firstFan != null) {
            if (vertices == firstFan.length) firstFan = ArrayGrowth.rows(firstFan, 1, vertices + 1, expectedVertices);
            firstFan[vertices] = fans; // the fan that is added next
        }
        if (lastWedge != null) {
            if (vertices == lastWedge.length)
                lastWedge = ArrayGrowth.rows(lastWedge, 1, vertices + 1, expectedVertices);
            lastWedge[vertices] = -1;
        }
        return vertices++;
    }

    /** Appends a fan vertex of a mesh vertex. The caller sets its cells. */
    public int addFan(int vertex) {
        if (4 * fans == places.length) places = ArrayGrowth.rows(places, 4, fans + 1, expectedFans);
        if (vertexOf != null) {
            if (fans == vertexOf.length) vertexOf = ArrayGrowth.rows(vertexOf, 1, fans + 1, expectedFans);
            vertexOf[fans] = vertex;
            if (firstFan[vertex] != fans) link(firstFan[vertex], fans);
        }
        return fans++;
    }

    private void link(int first, int fan) {
        if (fan >= nextFan.length) nextFan = ArrayGrowth.rows(nextFan, 1, fan + 1, expectedFans);
        nextFan[fan] = nextFan[first];
        nextFan[first] = fan;
    }

    /**
     * Makes room for the positions of so many splits, so that positions can be read and set while splits are applied.
     */
    public void reservePositions(int splits) {
        int vertex = Sizes.of((long) vertices + splits, "vertices");
        int fan = Sizes.of((long) fans + splits, "vertices");
        if (vertex > positionBits.length / 3)
            positionBits = ArrayGrowth.rows(positionBits, 3, vertex, expectedVertices);
        if (fan > places.length / 4) places = ArrayGrowth.rows(places, 4, fan, expectedFans);
        if (vertexOf == null) return;
        if (fan > vertexOf.length) vertexOf = ArrayGrowth.rows(vertexOf, 1, fan, expectedFans);
        if (vertex > firstFan.length) firstFan = ArrayGrowth.rows(firstFan, 1, vertex, expectedVertices);
    }

    /** Makes room in the table for what one more split adds. */
    public void growTable() {
        int faces = table.faces() + 2;
        if (faces > table.faceCapacity())
            table.reserve(ArrayGrowth.size(CornerTable.STRIDE, table.faceCapacity(), faces, expectedFaces), 0);
        if (fans + 1 > table.vertexCapacity())
            table.reserve(0, ArrayGrowth.size(1, table.vertexCapacity(), fans + 1, expectedFans));
    }

    /** Makes room in the table for so many faces in all, and for the fan vertices that are there. */
    public void reserveTable(int faces) {
        if (faces > table.faceCapacity())
            table.reserve(ArrayGrowth.size(CornerTable.STRIDE, table.faceCapacity(), faces, expectedFaces), 0);
        if (fans > table.vertexCapacity())
            table.reserve(0, ArrayGrowth.size(1, table.vertexCapacity(), fans, expectedFans));
    }

    /** Vertices that are expected in the end. */
    public int expectedVertices() {
        return expectedVertices;
    }

    /** Fan vertices that are expected in the end. */
    public int expectedFans() {
        return expectedFans;
    }

    /** Faces that are expected in the end, dummy ones included where an encoder knows them. */
    public int expectedFaces() {
        return expectedFaces;
    }

    /** Makes room for the wedges of all faces of the table. */
    public void growWedges() {
        int before = cornerWedges.length;
        if (!hasChannels && !hasMaterials || 4 * table.faces() <= before) return;
        cornerWedges = ArrayGrowth.rows(cornerWedges, 4, table.faces(), expectedFaces);
        Arrays.fill(cornerWedges, before, cornerWedges.length, -1);
    }

    public int wedge(int corner) {
        return hasChannels ? cornerWedges[4 * CornerTable.face(corner) + (corner & 3)] : vertexOf(table.vertex(corner));
    }

    public void setWedge(int corner, int wedge) {
        cornerWedges[4 * CornerTable.face(corner) + (corner & 3)] = wedge;
    }

    public int material(int face) {
        return hasMaterials ? cornerWedges[4 * face + 3] : -1;
    }

    public void setMaterial(int face, int material) {
        cornerWedges[4 * face + 3] = material;
    }

    public int addWedge(int vertex) {
        if (wedges == wedgeVertices.length) wedgeVertices = Arrays.copyOf(wedgeVertices, 2 * wedges);
        wedgeVertices[wedges] = vertex;
        if (lastWedge != null) {
            if (wedges == wedgeBefore.length) wedgeBefore = Arrays.copyOf(wedgeBefore, 2 * wedges);
            wedgeBefore[wedges] = lastWedge[vertex];
            lastWedge[vertex] = wedges;
        }
        return wedges++;
    }

    /** Does the mesh vertex of this fan vertex have other fans too? */
    public boolean isStitched(int fan) {
        return vertexOf != null && nextFan(firstFan[vertexOf[fan]]) != 0;
    }

    /** The last wedge that a mesh vertex was given, or −1. Only where there are stitches and channels. */
    public int lastWedge(int vertex) {
        return lastWedge[vertex];
    }

    /**
     * The wedge that the mesh vertex of a wedge got before this wedge, or −1. Only where there are stitches and
     * channels.
     */
    public int wedgeBefore(int wedge) {
        return wedgeBefore[wedge];
    }

    public int wedgeVertex(int wedge) {
        return hasChannels ? wedgeVertices[wedge] : wedge;
    }
}
