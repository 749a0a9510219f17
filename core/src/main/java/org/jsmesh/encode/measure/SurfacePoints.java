package org.jsmesh.encode.measure;

/**
 * Points spread evenly over the area of triangles. Many points are strewn, one per stratum of the running area, placed
 * by the additive recurrence R3 of Roberts 2018, 'The unreasonable effectiveness of quasirandom sequences'. Every so
 * many of them are taken, in the order of a curve through space. The same triangles give the same points. Immutable.
 */
public final class SurfacePoints {
    private static final double STEP_1 = 0.8191725133961645;
    private static final double STEP_2 = 0.6710436067037893;
    private static final double STEP_3 = 0.5497004779019703;

    private final float[] positions;
    private final int[] triangles;
    private final double[] areaUpTo;

    public SurfacePoints(float[] positions, int[] triangles) {
        this.positions = positions;
        this.triangles = triangles;
        areaUpTo = new double[triangles.length / 3];
        double area = 0;
        for (int i = 0; i < areaUpTo.length; i++) {
            area += area(positions, 3 * triangles[3 * i], 3 * triangles[3 * i + 1], 3 * triangles[3 * i + 2]);
            areaUpTo[i] = area;
        }
    }

    /**
     * @param strewn points for each one that is taken
     * @return x, y, z of so many points, in the order of the curve
     */
    double[] take(int count, int strewn) {
        double[] all = strew(strewn * count);
        float[] rounded = new float[all.length];
        int[] numbers = new int[all.length];
        for (int i = 0; i < all.length; i++) {
            rounded[i] = (float) all[i];
            numbers[i] = i / 3; // a triangle for each point
        }
        int[] order = CurveOrder.of(rounded, numbers, all.length / 3);
        double[] points = new double[3 * count];
        for (int k = 0; k < count; k++) {
            int from = 3 * order[strewn * k + strewn / 2];
            for (int axis = 0; axis < 3; axis++) points[3 * k + axis] = all[from + axis];
        }
        return points;
    }

    /** @return x, y, z of so many points, one per stratum of the area, in the order of the triangles */
    double[] strew(int count) {
        float[] p = positions;
        double[] points = new double[3 * count];
        double area = areaUpTo[areaUpTo.length - 1];
        int t = 0;
        for (int k = 0; k < count; k++) {
            double at = (k + fraction(k * STEP_1)) / count * area;
            while (t < areaUpTo.length - 1 && areaUpTo[t] <= at) t++;
            double u = fraction(k * STEP_2);
            double v = fraction(k * STEP_3);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            for (int axis = 0; axis < 3; axis++)
                points[3 * k + axis] = p[3 * triangles[3 * t] + axis] * (1 - u - v)
                        + p[3 * triangles[3 * t + 1] + axis] * u
                        + p[3 * triangles[3 * t + 2] + axis] * v;
        }
        return points;
    }

    private static double fraction(double x) {
        return x - Math.floor(x);
    }

    /** Area of the triangle of three vertices whose coordinates begin at a, b and c. */
    private static double area(float[] p, int a, int b, int c) {
        double ax = (double) p[b] - p[a];
        double ay = (double) p[b + 1] - p[a + 1];
        double az = (double) p[b + 2] - p[a + 2];
        double bx = (double) p[c] - p[a];
        double by = (double) p[c + 1] - p[a + 1];
        double bz = (double) p[c + 2] - p[a + 2];
        double nx = ay * bz - az * by;
        double ny = az * bx - ax * bz;
        double nz = ax * by - ay * bx;
        return 0.5 * Math.sqrt(nx * nx + ny * ny + nz * nz);
    }
}
