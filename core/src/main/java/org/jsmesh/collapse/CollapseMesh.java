package org.jsmesh.collapse;

import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.ManifoldCut;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.patch.PatchLog;

/**
 * A mesh under simplification: its manifold cut, the wedge of every corner, and the half-edge collapse with its log. Vertices are fan vertices.
 */
public final class CollapseMesh {
    /** First value of a face that a collapse removed. */
    private static final int REMOVED = -2;

    private final Mesh mesh;
    private final CornerTable table;
    private final int[] vertexOf;
    private final boolean[] cut;
    private final int[] cornerWedges; // 4 per real face: three wedges and the material
    private final PatchLog log = new PatchLog();
    private final boolean hasWedges;

    public CollapseMesh(Mesh mesh) {
        this.mesh = mesh;
        ManifoldCut manifold = new ManifoldCut(mesh);
        table = manifold.table();
        vertexOf = manifold.vertexOf();
        cut = new boolean[vertexOf.length];
        for (int v = mesh.vertices(); v < vertexOf.length; v++) {
            cut[v] = true;
            cut[vertexOf[v]] = true;
        }
        cornerWedges = new int[4 * mesh.faces()];
        for (int f = 0; f < mesh.faces(); f++) {
            System.arraycopy(mesh.faceWedges(), 3 * f, cornerWedges, 4 * f, 3);
            cornerWedges[4 * f + 3] = mesh.faceMaterials()[f];
        }
        hasWedges = !mesh.channels().isEmpty() || !mesh.materials().isEmpty();
    }

    /** The mesh as it was given. */
    public Mesh original() {
        return mesh;
    }

    public CornerTable table() {
        return table;
    }

    public PatchLog log() {
        return log;
    }

    /** Mesh vertex of each fan vertex. */
    public int[] vertexOf() {
        return vertexOf;
    }

    /** True when the mesh vertex of this fan vertex has other fans too, so that it must stay. */
    public boolean isCut(int vertex) {
        return cut[vertex];
    }

    /** True when wedges or materials can make an edge sharp. */
    public boolean hasWedges() {
        return hasWedges;
    }

    /** x, y or z of a fan vertex. */
    public float position(int vertex, int axis) {
        return mesh.positions()[3 * vertexOf[vertex] + axis];
    }

    /** True for faces of the original that are still there: neither dummy nor removed. */
    public boolean isLiveFace(int face) {
        return face < mesh.faces() && table.vertex(CornerTable.STRIDE * face) != REMOVED;
    }

    /** Number of faces that are still there. */
    public int liveFaces() {
        int n = 0;
        for (int f = 0; f < mesh.faces(); f++) if (isLiveFace(f)) n++;
        return n;
    }

    /** Wedge at a corner of a real face. */
    public int wedge(int corner) {
        return cornerWedges[4 * CornerTable.face(corner) + (corner & 3)];
    }

    public int material(int face) {
        return cornerWedges[4 * face + 3];
    }

    /**
     * Is the edge that the faces of {@code corner} and {@code swing(corner)} share sharp: a boundary, a change of material, or different wedges at either end?
     * The edge leads from the corner's vertex to {@code previous(corner)}.
     */
    public boolean isSharp(int corner) {
        int other = table.swing(corner);
        int f = CornerTable.face(corner);
        int g = CornerTable.face(other);
        if (f >= mesh.faces() || g >= mesh.faces()) return true;
        if (!hasWedges) return false;
        return material(f) != material(g)
                || wedge(corner) != wedge(other)
                || wedge(CornerTable.previous(corner)) != wedge(CornerTable.next(other));
    }

    /**
     * Collapses the half-edge u→v that leaves from corner {@code h} (vertex u, next corner v): u is removed, its faces on both sides of the edge vanish, its other faces become faces of v
     * and take v's wedges, sector by sector. The patch is logged. Nothing is tested.
     */
    public void collapse(int h) {
        CornerTable t = table;
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
        moveRun(h, first, right, v);

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

    /** Gives the faces of the run to v; their wedges are v's in the left face up to the first sharp edge of u, then v's in the right face. */
    private void moveRun(int h, int first, int right, int v) {
        int real = mesh.faces();
        int rightWedge = CornerTable.face(right) < real ? wedge(CornerTable.previous(right)) : -1;
        int wedge = CornerTable.face(h) < real ? wedge(CornerTable.next(h)) : rightWedge;
        boolean sharp = hasWedges && isSharp(h);
        int next;
        for (int c = first; c != right; c = next) {
            next = table.swing(c);
            if (hasWedges) {
                if (sharp && rightWedge >= 0) wedge = rightWedge;
                sharp = isSharp(c);
                boolean live = CornerTable.face(c) < real;
                log.addRunWedge(live ? wedge(c) : -1);
                if (live) cornerWedges[4 * CornerTable.face(c) + (c & 3)] = wedge;
            } else if (CornerTable.face(c) < real) {
                cornerWedges[4 * CornerTable.face(c) + (c & 3)] = wedge;
            }
            table.data()[c] = v;
        }
    }
}
