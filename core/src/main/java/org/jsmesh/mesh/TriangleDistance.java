package org.jsmesh.mesh;

/**
 * Distances between points and triangles: Ericson 2004, 'Real-Time Collision Detection', section 5.1.5; triangles may
 * be degenerate.
 */
public final class TriangleDistance {
    private TriangleDistance() {}

    /**
     * Measures from a point to a triangle.
     *
     * @param p coordinates of the corners
     * @param a where x, y, z of the first corner begin in p
     * @param b where those of the second corner begin
     * @param c where those of the third corner begin
     * @param x of the point
     * @param y of the point
     * @param z of the point
     * @return the squared distance to the nearest point of the triangle
     */
    public static double squared(float[] p, int a, int b, int c, double x, double y, double z) {
        double ax = p[a];
        double ay = p[a + 1];
        double az = p[a + 2];
        return squared(
                p[b] - ax,
                p[b + 1] - ay,
                p[b + 2] - az,
                p[c] - ax,
                p[c + 1] - ay,
                p[c + 2] - az,
                x - ax,
                y - ay,
                z - az);
    }

    /**
     * Measures from a point to a triangle in whole coordinates.
     *
     * @param p coordinates of the corners
     * @param a where x, y, z of the first corner begin in p
     * @param b where those of the second corner begin
     * @param c where those of the third corner begin
     * @param x of the point
     * @param y of the point
     * @param z of the point
     * @return the squared distance to the nearest point of the triangle
     */
    public static double squared(int[] p, int a, int b, int c, double x, double y, double z) {
        double ax = p[a];
        double ay = p[a + 1];
        double az = p[a + 2];
        return squared(
                p[b] - ax,
                p[b + 1] - ay,
                p[b + 2] - az,
                p[c] - ax,
                p[c + 1] - ay,
                p[c + 2] - az,
                x - ax,
                y - ay,
                z - az);
    }

    /** From point p to the triangle of a, b and c, all as seen from a. */
    private static double squared(
            double abx,
            double aby,
            double abz,
            double acx,
            double acy,
            double acz,
            double apx,
            double apy,
            double apz) {
        double d1 = abx * apx + aby * apy + abz * apz;
        double d2 = acx * apx + acy * apy + acz * apz;
        if (d1 <= 0 && d2 <= 0) return square(apx, apy, apz);
        double bb = abx * abx + aby * aby + abz * abz;
        double bc = abx * acx + aby * acy + abz * acz;
        double d3 = d1 - bb;
        double d4 = d2 - bc;
        if (d3 >= 0 && d4 <= d3) return square(apx - abx, apy - aby, apz - abz);
        double vc = d1 * d4 - d3 * d2;
        double v;
        double w;
        if (vc <= 0 && d1 >= 0 && d3 <= 0 && bb > 0) {
            v = d1 / bb;
            w = 0;
        } else {
            double cc = acx * acx + acy * acy + acz * acz;
            double d5 = d1 - bc;
            double d6 = d2 - cc;
            if (d6 >= 0 && d5 <= d6) return square(apx - acx, apy - acy, apz - acz);
            double vb = d5 * d2 - d1 * d6;
            double va = d3 * d6 - d5 * d4;
            if (vb <= 0 && d2 >= 0 && d6 <= 0) {
                v = 0;
                w = d2 / cc;
            } else if (va <= 0 && d4 >= d3 && d5 >= d6) {
                w = (d4 - d3) / (d4 - d3 + d5 - d6);
                v = 1 - w;
            } else {
                double sum = va + vb + vc;
                v = sum > 0 ? vb / sum : 0;
                w = sum > 0 ? vc / sum : 0;
            }
        }
        return square(apx - v * abx - w * acx, apy - v * aby - w * acy, apz - v * abz - w * acz);
    }

    private static double square(double x, double y, double z) {
        return x * x + y * y + z * z;
    }
}
