package org.jsmesh.collapse;

import org.jsmesh.mesh.CornerTable;

/**
 * The flip test (figure 4 of Chen and Nishita 2002): a half-edge collapse must not turn a face over or leave one
 * without area. Works on a measured {@link VertexStar}.
 */
final class FlipTest {
    /** Of a new face, in squared diagonals. */
    private static final double LEAST_AREA = 1e-14;

    private final double leastCosine;

    /** @param leastCosine between the old and the new normal of a face */
    FlipTest(double leastCosine) {
        this.leastCosine = leastCosine;
    }

    /** Do the faces that go to the neighbour {@code target} keep some of their area and of their direction? */
    boolean keepsOrientation(VertexStar star, int target) {
        double[] e = star.edge;
        double[] normal = star.normal;
        int n = star.size;
        int t = 3 * target;
        double dx = e[t];
        double dy = e[t + 1];
        double dz = e[t + 2];
        int i = target + 1 == n ? 0 : target + 1;
        for (int left = n - 2; left > 0; left--) {
            int ahead = i + 1 == n ? 0 : i + 1;
            if (star.neighbour[i] != CornerTable.OUTSIDE && star.neighbour[ahead] != CornerTable.OUTSIDE) {
                int k = 3 * i;
                double ax = e[k] - dx;
                double ay = e[k + 1] - dy;
                double az = e[k + 2] - dz;
                double bx = e[3 * ahead] - dx;
                double by = e[3 * ahead + 1] - dy;
                double bz = e[3 * ahead + 2] - dz;
                double nx = ay * bz - az * by;
                double ny = az * bx - ax * bz;
                double nz = ax * by - ay * bx;
                double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
                if (!(length > 2 * LEAST_AREA)) return false;
                double old = star.normalLength[i];
                double cosine = nx * normal[k] + ny * normal[k + 1] + nz * normal[k + 2];
                if (old > 2 * LEAST_AREA && cosine < leastCosine * old * length) return false;
            }
            i = ahead;
        }
        return true;
    }
}
