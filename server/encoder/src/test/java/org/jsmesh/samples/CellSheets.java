package org.jsmesh.samples;

/**
 * The sheets of surface in one cell of a grid, each named by the first of the cell's edges that it crosses. Edge
 * {@code 4 a + u + 2 v} runs along axis a, at the low (0) or high (1) end of the next axis and the one after.
 */
final class CellSheets {
    private final int[] sheet = new int[12];
    private int inside;

    /**
     * Joins the crossed edges of each face of the cell; where all four are crossed, the inner corners are kept apart.
     *
     * @param inside a bit per corner of the cell
     */
    void separate(int inside) {
        this.inside = inside;
        for (int edge = 0; edge < 12; edge++) sheet[edge] = edge;
        for (int face = 0; face < 6; face++) {
            int normal = face / 2;
            int end = face % 2;
            int u = (normal + 1) % 3;
            int v = (normal + 2) % 3;
            // Along u the edges are numbered by v, then by the normal; along v by the normal, then by u.
            int[] alongU = {4 * u + 2 * end, 4 * u + 1 + 2 * end};
            int[] alongV = {4 * v + end, 4 * v + end + 2};
            boolean all = true;
            int crossed = -1;
            for (int edge : new int[] {alongU[0], alongU[1], alongV[0], alongV[1]}) {
                if (isCrossed(edge)) {
                    if (crossed >= 0) continue;
                    crossed = edge;
                } else {
                    all = false;
                }
            }
            for (int corner = 0; corner < 4 && all; corner++) {
                int iu = corner & 1;
                int iv = corner >> 1;
                if ((inside >> (end << normal | iu << u | iv << v) & 1) != 0) join(alongU[iv], alongV[iu]);
            }
            for (int edge : new int[] {alongU[0], alongU[1], alongV[0], alongV[1]}) {
                if (!all && isCrossed(edge)) join(crossed, edge);
            }
        }
    }

    /** Whether the surface crosses the edge, and does so with this sheet. */
    boolean holds(int of, int edge) {
        return isCrossed(edge) && sheet[edge] == of;
    }

    private void join(int a, int b) {
        int from = sheet[a];
        int to = sheet[b];
        int root = StrictMath.min(from, to);
        for (int edge = 0; edge < 12; edge++) {
            if (sheet[edge] == from || sheet[edge] == to) sheet[edge] = root;
        }
    }

    /** The corner of the cell at an edge's low end. */
    static int low(int edge) {
        int axis = edge / 4;
        return (edge & 1) << (axis + 1) % 3 | (edge >> 1 & 1) << (axis + 2) % 3;
    }

    private boolean isCrossed(int edge) {
        int corner = low(edge);
        return ((inside >> corner ^ inside >> (corner | 1 << edge / 4)) & 1) != 0;
    }
}
