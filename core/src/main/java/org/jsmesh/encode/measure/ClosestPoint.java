package org.jsmesh.encode.measure;

/** The point of a triangle that is closest to another point, as shares of the corners. */
final class ClosestPoint {
    /** The shares, which add up to 1. */
    final double[] shares = new double[3];

    /** From it to the other point, with a length of 1: the normal of the triangle if it is inside; 0 if unknown. */
    final double[] direction = new double[3];

    private final double[] candidate = new double[3];
    private double best;

    /** Finds the point on the triangle of three vertices {@code list[at .. at + 2]}. */
    void find(float[] positions, int[] list, int at, double x, double y, double z) {
        find(positions, 3 * list[at], 3 * list[at + 1], 3 * list[at + 2], x, y, z);
    }

    /** Finds the point of the triangle whose nine coordinates begin at {@code at}. */
    void find(float[] corners, int at, double x, double y, double z) {
        find(corners, at, at + 3, at + 6, x, y, z);
    }

    private void find(float[] positions, int corner, int second, int third, double x, double y, double z) {
        double[] b = new double[3];
        double[] c = new double[3];
        double[] p = {x - positions[corner], y - positions[corner + 1], z - positions[corner + 2]};
        for (int i = 0; i < 3; i++) {
            b[i] = (double) positions[second + i] - positions[corner + i];
            c[i] = (double) positions[third + i] - positions[corner + i];
        }
        double bb = dot(b, b);
        double bc = dot(b, c);
        double cc = dot(c, c);
        double pb = dot(p, b);
        double pc = dot(p, c);
        double area = bb * cc - bc * bc;
        if (area > 0) {
            double v = (cc * pb - bc * pc) / area;
            double w = (bb * pc - bc * pb) / area;
            set(shares, 1 - v - w, v, w);
            if (shares[0] >= 0 && v >= 0 && w >= 0) {
                setDirection(b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]);
                return;
            }
        }
        best = Double.POSITIVE_INFINITY;
        double onB = within(pb, bb);
        offer(1 - onB, onB, 0, p, b, c);
        double onC = within(pc, cc);
        offer(1 - onC, 0, onC, p, b, c);
        double across = within(pc - pb - bc + bb, bb - 2 * bc + cc);
        offer(0, 1 - across, across, p, b, c);
        double v = shares[1];
        double w = shares[2];
        setDirection(p[0] - v * b[0] - w * c[0], p[1] - v * b[1] - w * c[1], p[2] - v * b[2] - w * c[2]);
    }

    private void setDirection(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        set(direction, x, y, z);
        if (length > 0) for (int i = 0; i < 3; i++) direction[i] /= length;
    }

    private static double within(double part, double length) {
        return part <= 0 ? 0 : part >= length ? 1 : part / length;
    }

    private void offer(double u, double v, double w, double[] p, double[] b, double[] c) {
        for (int i = 0; i < 3; i++) candidate[i] = p[i] - v * b[i] - w * c[i];
        double distance = dot(candidate, candidate);
        if (distance >= best) return;
        best = distance;
        set(shares, u, v, w);
    }

    private static void set(double[] to, double u, double v, double w) {
        to[0] = u;
        to[1] = v;
        to[2] = w;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
