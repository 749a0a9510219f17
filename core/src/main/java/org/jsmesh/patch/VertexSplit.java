package org.jsmesh.patch;

import org.jsmesh.mesh.CornerTable;

/** Applies vertex splits to a corner table (section 5.1 and figure 7 of Chen and Nishita 2002). */
public final class VertexSplit {
    private VertexSplit() {}

    /**
     * Splits vertex v: a new vertex takes the faces of the run, and two new faces close the gaps on both sides of the
     * new edge. The left face is (v, x0, new), the right one (v, new, xc), where x0 and xc are the neighbours of v at
     * the run's ends; a new face is a dummy one where its neighbour is {@link CornerTable#OUTSIDE}.
     *
     * @param first corner at v of the run's first face
     * @param last corner at v of the run's last face, counter-clockwise of first or equal to it; not all faces of v may
     *     be in the run
     * @return the new vertex; the new faces are the last two of the table
     */
    public static int apply(CornerTable t, int first, int last) {
        int v = t.vertex(first);
        int before = t.swingBack(first);
        int after = t.swing(last);
        int x0 = t.vertex(CornerTable.next(first));
        int xc = t.vertex(CornerTable.previous(last));
        int u = t.addVertex();
        for (int c = first; ; c = t.swing(c)) {
            t.data()[c] = u;
            if (c == last) break;
        }
        int left = CornerTable.STRIDE * t.addFace(v, x0, u);
        int right = CornerTable.STRIDE * t.addFace(v, u, xc);
        t.setSwing(before, left);
        t.setSwing(left, right);
        t.setSwing(right, after);
        t.setSwing(last, right + 1);
        t.setSwing(right + 1, left + 2);
        t.setSwing(left + 2, first);
        t.setSwing(CornerTable.next(first), left + 1);
        t.setSwing(left + 1, CornerTable.previous(before));
        t.setSwing(CornerTable.next(after), right + 2);
        t.setSwing(right + 2, CornerTable.previous(last));
        t.setCornerOf(v, left);
        t.setCornerOf(u, first);
        return u;
    }
}
