package org.jsmesh.collapse;

import java.util.Arrays;
import java.util.BitSet;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.ManifoldCut;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.patch.PatchLog;

/**
 * A mesh under simplification: its manifold cut, the wedge of every corner, and the half-edge collapse with its log.
 * Vertices are fan vertices.
 */
public final class CollapseMesh {
    /** First value of a face that a collapse removed. */
    private static final int REMOVED = -2;

    private final Mesh mesh;
    private ManifoldCut manifold; // until its table is asked for
    private CornerTable table; // null when released
    private int[] apart; // fan vertex of corner 3 f + j where no face has a neighbour, else null
    private final int[] vertexOf;
    private boolean[] cut; // null when released
    private final int[] cornerWedges; // 4 per real face: three wedges and the material; null where they are not needed
    private final PatchLog log = new PatchLog();
    private BitSet gone; // faces of removed components; null when there are none
    private final boolean hasWedges;
    private final boolean hasTexture;
    private boolean isSeparate;

    public CollapseMesh(Mesh mesh) {
        this.mesh = mesh;
        manifold = new ManifoldCut(mesh);
        vertexOf = manifold.vertexOf();
        if (manifold.isApart()) {
            apart = manifold.fans();
        } else {
            table = manifold.table();
            manifold = null;
        }
        cut = new boolean[vertexOf.length];
        for (int v = mesh.vertices(); v < vertexOf.length; v++) {
            cut[v] = true;
            cut[vertexOf[v]] = true;
        }
        hasTexture = mesh.channel(Channel.Semantic.TEXCOORD) != null;
        hasWedges = !mesh.channels().isEmpty() || !mesh.materials().isEmpty();
        cornerWedges = hasWedges ? cornerWedges(mesh) : null;
    }

    private static int[] cornerWedges(Mesh mesh) {
        int[] wedges = new int[4 * mesh.faces()];
        for (int f = 0; f < mesh.faces(); f++) {
            System.arraycopy(mesh.faceWedges(), 3 * f, wedges, 4 * f, 3);
            wedges[4 * f + 3] = mesh.faceMaterials()[f];
        }
        return wedges;
    }

    /** The mesh as it was given. */
    public Mesh original() {
        return mesh;
    }

    public CornerTable table() {
        if (manifold != null) {
            table = manifold.table();
            manifold = null;
        }
        return table;
    }

    /** Has no face a neighbour? */
    public boolean isApart() {
        return apart != null;
    }

    /** Makes the table one without dummy faces, which is enough where no face has a neighbour. */
    void separate() {
        manifold = null;
        table = SeparateTriangles.table(apart, vertexOf.length);
        isSeparate = true;
    }

    /** True when the table has no dummy faces, since no face has a neighbour. */
    public boolean isSeparate() {
        return isSeparate;
    }

    /** Fan vertex of corner j of a face that no collapse has removed. */
    public int fan(int face, int j) {
        return isSeparate ? apart[3 * face + j] : table().vertex(CornerTable.STRIDE * face + j);
    }

    public PatchLog log() {
        return log;
    }

    /** Mesh vertex of each fan vertex. */
    public int[] vertexOf() {
        return vertexOf;
    }

    /** True when the mesh vertex of this fan vertex has other fans too. */
    public boolean isCut(int vertex) {
        return cut[vertex];
    }

    /** True when wedges or materials can make an edge sharp. */
    public boolean hasWedges() {
        return hasWedges;
    }

    /**
     * True when there are texture coordinates. The charts of a texture must stay apart, because a face with corners in
     * two of them would show the texture between. Normals and colours of two regions may meet in a face of a coarse
     * mesh.
     */
    public boolean hasTexture() {
        return hasTexture;
    }

    /** x, y, z of each fan vertex; not to be changed. */
    float[] fanPositions() {
        if (vertexOf.length == mesh.vertices()) return mesh.positions();
        float[] positions = Arrays.copyOf(mesh.positions(), 3 * vertexOf.length);
        for (int i = 3 * mesh.vertices(); i < positions.length; i++)
            positions[i] = positions[3 * vertexOf[i / 3] + i % 3];
        return positions;
    }

    /** x, y or z of a fan vertex. */
    public float position(int vertex, int axis) {
        return mesh.positions()[3 * vertexOf[vertex] + axis];
    }

    /** True for faces of the original that are still there: neither dummy nor removed. */
    public boolean isLiveFace(int face) {
        return face < mesh.faces()
                && (isSeparate || table().vertex(CornerTable.STRIDE * face) != REMOVED)
                && (gone == null || !gone.get(face));
    }

    /** Number of faces that are still there. */
    public int liveFaces() {
        int n = 0;
        for (int f = 0; f < mesh.faces(); f++) if (isLiveFace(f)) n++;
        return n;
    }

    /**
     * Releases the table, unless it is needed to find wedges or components. What is left of the mesh is known
     * elsewhere.
     */
    public void release() {
        cut = null;
        if (hasWedges || gone != null && !isSeparate) return;
        manifold = null;
        table = null;
    }

    /**
     * Wedge at a corner of a real face. For a removed face it is known only where wedges or materials can make an edge
     * sharp. Where they cannot, vertices stand for their wedges.
     */
    public int wedge(int corner) {
        if (!hasWedges) return vertexOf[table().vertex(corner)];
        return cornerWedges[4 * CornerTable.face(corner) + (corner & 3)];
    }

    public int material(int face) {
        return hasWedges ? cornerWedges[4 * face + 3] : -1;
    }

    /** Are both faces real and of the same material? */
    boolean isSameMaterial(int face, int other) {
        return face < mesh.faces() && other < mesh.faces() && material(face) == material(other);
    }

    /**
     * Is the edge that the faces of {@code corner} and {@code swing(corner)} share sharp: a boundary, a change of
     * material, or different wedges at either end? The edge leads from the corner's vertex to {@code previous(corner)}.
     */
    public boolean isSharp(int corner) {
        int other = table().swing(corner);
        int f = CornerTable.face(corner);
        int g = CornerTable.face(other);
        if (f >= mesh.faces() || g >= mesh.faces()) return true;
        if (!hasWedges) return false;
        return material(f) != material(g)
                || wedge(corner) != wedge(other)
                || wedge(CornerTable.previous(corner)) != wedge(CornerTable.next(other));
    }

    /**
     * Collapses the half-edge u→v that leaves from corner {@code h} (vertex u, next corner v). Removes u and its faces
     * on both sides of the edge. Its other faces become faces of v and take v's wedges, sector by sector. Logs the
     * patch. Tests nothing.
     */
    public void collapse(int h) {
        CornerTable t = table();
        int leftV = CornerTable.next(h);
        int leftX = CornerTable.previous(h);
        int right = t.swingBack(h);
        int rightX = CornerTable.next(right);
        int rightV = CornerTable.previous(right);
        int first = t.swing(h);
        int last = t.swingBack(right);
        int before = t.swingBack(leftV);
        int after = t.swing(rightV);
        int u = t.vertex(h);
        int v = t.vertex(leftV);
        int x0 = t.vertex(leftX);
        int xc = t.vertex(rightX);
        int leftFace = CornerTable.face(h);
        int rightFace = CornerTable.face(right);

        int length = 0;
        for (int c = first; c != right; c = t.swing(c)) length++;
        log.add(u, v, leftFace, rightFace, CornerTable.face(first), length);
        if (hasWedges) moveRun(h, first, right, v);
        else for (int c = first; c != right; c = t.swing(c)) t.data()[c] = v;

        t.setSwing(before, first);
        t.setSwing(last, after);
        t.setSwing(CornerTable.next(first), CornerTable.previous(before));
        t.setSwing(CornerTable.next(after), CornerTable.previous(last));
        t.setCornerOf(v, first);
        t.setCornerOf(u, -1);
        if (x0 != CornerTable.OUTSIDE) t.setCornerOf(x0, CornerTable.next(first));
        if (xc != CornerTable.OUTSIDE) t.setCornerOf(xc, CornerTable.next(after));
        t.data()[CornerTable.STRIDE * leftFace] = REMOVED;
        t.data()[CornerTable.STRIDE * rightFace] = REMOVED;
    }

    /**
     * Removes a component with all its faces and vertices, and logs that. Its part of the table stays as it is, but its
     * vertices have no corner.
     *
     * @param component all real faces that are connected with the first of them
     * @param vertices of these faces, fan vertices
     */
    void removeComponent(int[] component, int faces, int[] vertices, int vertexCount) {
        if (gone == null) gone = new BitSet(mesh.faces());
        for (int i = 0; i < faces; i++) gone.set(component[i]);
        for (int i = 0; i < vertexCount; i++) table.setCornerOf(vertices[i], -1);
        log.addComponent(component[0], vertexCount);
    }

    /**
     * Gives the faces of the run to v, with v's wedges. Sectors lie between sharp edges of u. In the sectors of the
     * left and of the right face they get the wedges that v has there; in a sector between, they get the wedge of v
     * that is most like u's.
     */
    private void moveRun(int h, int first, int right, int v) {
        int real = mesh.faces();
        int leftWedge = CornerTable.face(h) < real ? wedge(CornerTable.next(h)) : -1;
        int rightWedge = CornerTable.face(right) < real ? wedge(CornerTable.previous(right)) : -1;
        int lastSharp = faceBehindLastSharpEdge(h, right);
        boolean rightSector = false;
        int wedge = leftWedge >= 0 ? leftWedge : rightWedge;
        boolean sharp = isSharp(h);
        int next;
        for (int c = first; c != right; c = next) {
            next = table.swing(c);
            boolean live = CornerTable.face(c) < real;
            if (sharp) {
                rightSector |= c == lastSharp && rightWedge >= 0;
                if (rightSector) wedge = rightWedge;
                else if (live) wedge = LikeWedge.of(this, v, wedge(c), wedge);
            }
            sharp = isSharp(c);
            log.addRunWedge(live ? wedge(c) : -1);
            if (live) cornerWedges[4 * CornerTable.face(c) + (c & 3)] = wedge;
            table.data()[c] = v;
        }
    }

    /** Corner of u behind the last sharp edge on the way from its left face to its right one, or −1. */
    private int faceBehindLastSharpEdge(int h, int right) {
        int last = -1;
        for (int c = h; c != right; c = table.swing(c)) if (isSharp(c)) last = table.swing(c);
        return last;
    }
}
