package org.jsmesh.collapse;

import org.jsmesh.mesh.CornerTable;

/**
 * Distances from points to the faces that a collapse leaves around its target: those of a {@link VertexStar} without
 * the two at the edge. Points are relative to the removed vertex. Distance to a triangle: Ericson 2004, 'Real-Time
 * Collision Detection', section 5.1.5. Not thread-safe.
 */
final class FanDistance {
    private static final int ROW = 9;

    /** Factor of the squared distance from the target, for an ear of the boundary that is removed as a whole. */
    private static final double LOSS = 100;

    private final double[] faces =
            new double[ROW * (VertexStar.MOST_FACES + 1)]; // two edges from the target, their products
    private final int[] index = new int[VertexStar.MOST_FACES + 1]; // of the face in the star
    private int count;
    private double targetX;
    private double targetY;
    private double targetZ;
    private int nearest;

    /** Takes the faces that would be left after the collapse to a neighbour. */
    void set(VertexStar star, int target) {
        double[] e = star.edge;
        int n = star.size;
        targetX = e[3 * target];
        targetY = e[3 * target + 1];
        targetZ = e[3 * target + 2];
        count = 0;
        int i = target + 1 == n ? 0 : target + 1;
        for (int left = n - 2; left > 0; left--) {
            int ahead = i + 1 == n ? 0 : i + 1;
            if (star.neighbour[i] != CornerTable.OUTSIDE && star.neighbour[ahead] != CornerTable.OUTSIDE)
                add(i, e, 3 * i, 3 * ahead);
            i = ahead;
        }
    }

    private void add(int face, double[] e, int b, int c) {
        double bx = e[b] - targetX;
        double by = e[b + 1] - targetY;
        double bz = e[b + 2] - targetZ;
        double cx = e[c] - targetX;
        double cy = e[c + 1] - targetY;
        double cz = e[c + 2] - targetZ;
        int at = ROW * count;
        faces[at] = bx;
        faces[at + 1] = by;
        faces[at + 2] = bz;
        faces[at + 3] = cx;
        faces[at + 4] = cy;
        faces[at + 5] = cz;
        faces[at + 6] = bx * bx + by * by + bz * bz;
        faces[at + 7] = bx * cx + by * cy + bz * cz;
        faces[at + 8] = cx * cx + cy * cy + cz * cz;
        index[count++] = face;
    }

    /** Are no faces left? */
    boolean isEmpty() {
        return count == 0;
    }

    /**
     * Squared distance from a point to the closest of the faces. When there is no face, it is larger than the squared
     * distance to the target.
     */
    double squared(double x, double y, double z) {
        double px = x - targetX;
        double py = y - targetY;
        double pz = z - targetZ;
        if (count == 0) return LOSS * (px * px + py * py + pz * pz);
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double d = squared(ROW * i, px, py, pz);
            if (d < least) {
                least = d;
                nearest = index[i];
            }
        }
        return least;
    }

    /** The face of the star closest to the point last asked for. */
    int nearest() {
        return nearest;
    }

    private double squared(int at, double px, double py, double pz) {
        double[] f = faces;
        double bb = f[at + 6];
        double bc = f[at + 7];
        double cc = f[at + 8];
        double pb = px * f[at] + py * f[at + 1] + pz * f[at + 2];
        double pc = px * f[at + 3] + py * f[at + 4] + pz * f[at + 5];
        double v = cc * pb - bc * pc;
        double w = bb * pc - bc * pb;
        double area = bb * cc - bc * bc;
        double s;
        double t;
        if (v >= 0 && w >= 0 && v + w <= area && area > 0) {
            s = v / area;
            t = w / area;
        } else if (w < 0 && pb > 0 && (v >= 0 || pc <= 0 || pb * pb * cc > pc * pc * bb)) {
            s = pb >= bb ? 1 : pb / bb;
            t = 0;
            if (pb > bb && pc - pb > bc - bb) return across(f, at, px, py, pz, bb, bc, cc, pb, pc);
        } else if (v < 0 && pc > 0) {
            s = 0;
            t = pc >= cc ? 1 : pc / cc;
            if (pc > cc && pb - pc > bc - cc) return across(f, at, px, py, pz, bb, bc, cc, pb, pc);
        } else if (v >= 0 && w >= 0) {
            return across(f, at, px, py, pz, bb, bc, cc, pb, pc);
        } else {
            s = 0;
            t = 0;
        }
        return length(f, at, px, py, pz, s, t);
    }

    /** The distance to the edge that faces the target. */
    private static double across(
            double[] f,
            int at,
            double px,
            double py,
            double pz,
            double bb,
            double bc,
            double cc,
            double pb,
            double pc) {
        double length = bb - 2 * bc + cc;
        double t = length > 0 ? Math.max(0, Math.min(1, (pc - pb - bc + bb) / length)) : 0;
        return length(f, at, px, py, pz, 1 - t, t);
    }

    private static double length(double[] f, int at, double px, double py, double pz, double s, double t) {
        double x = px - s * f[at] - t * f[at + 3];
        double y = py - s * f[at + 1] - t * f[at + 4];
        double z = pz - s * f[at + 2] - t * f[at + 5];
        return x * x + y * y + z * z;
    }
}
