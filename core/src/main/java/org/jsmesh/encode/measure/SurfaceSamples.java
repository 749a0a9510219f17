package org.jsmesh.encode.measure;

/**
 * Points spread evenly over the area of some triangles, in the order of a {@link TriangleTree}: one point per stratum
 * of the running area, placed by the additive recurrence R3 of Roberts 2018, 'The unreasonable effectiveness of
 * quasirandom sequences'. The same triangles give the same points.
 */
final class SurfaceSamples {
    private static final double STEP_1 = 0.8191725133961645;
    private static final double STEP_2 = 0.6710436067037893;
    private static final double STEP_3 = 0.5497004779019703;

    private final double[] points;

    SurfaceSamples(TriangleTree tree, int samples) {
        points = new double[3 * samples];
        float[] c = tree.corners();
        double[] areaUpTo = new double[tree.size()];
        double area = 0;
        for (int i = 0; i < areaUpTo.length; i++) {
            area += area(c, 9 * i);
            areaUpTo[i] = area;
        }
        int triangle = 0;
        for (int k = 0; k < samples; k++) {
            double at = (k + fraction(k * STEP_1)) / samples * area;
            while (triangle < areaUpTo.length - 1 && areaUpTo[triangle] <= at) triangle++;
            double u = fraction(k * STEP_2);
            double v = fraction(k * STEP_3);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            int t = 9 * triangle;
            for (int axis = 0; axis < 3; axis++) {
                points[3 * k + axis] = c[t + axis] * (1 - u - v) + c[t + 3 + axis] * u + c[t + 6 + axis] * v;
            }
        }
    }

    /** x, y, z of each point. */
    double[] points() {
        return points;
    }

    private static double fraction(double x) {
        return x - Math.floor(x);
    }

    private static double area(float[] c, int t) {
        double ax = (double) c[t + 3] - c[t];
        double ay = (double) c[t + 4] - c[t + 1];
        double az = (double) c[t + 5] - c[t + 2];
        double bx = (double) c[t + 6] - c[t];
        double by = (double) c[t + 7] - c[t + 1];
        double bz = (double) c[t + 8] - c[t + 2];
        double nx = ay * bz - az * by;
        double ny = az * bx - ax * bz;
        double nz = ax * by - ay * bx;
        return 0.5 * Math.sqrt(nx * nx + ny * ny + nz * nz);
    }
}
