package org.jsmesh.samples;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * The textured sample: a neck amphora with two handles. Its wall, its inside and each handle are charts of one texture,
 * with seams between them.
 */
final class Amphora {
    private static final int SECTORS = 96;
    private static final int STEPS_PER_SPAN = 3;

    /** Distance from the axis and height, from the middle of the foot's underside to the inner edge of the lip. */
    private static final double[][] WALL = {
        {0.30, 0.05}, {0.50, 0.02}, {0.62, 0.00}, {0.66, 0.04}, {0.66, 0.12}, {0.56, 0.20}, {0.46, 0.27}, {0.50, 0.40},
        {0.72, 0.72}, {0.98, 1.12}, {1.20, 1.55}, {1.34, 2.00}, {1.37, 2.42}, {1.26, 2.80}, {1.02, 3.10}, {0.74, 3.30},
        {0.56, 3.45}, {0.49, 3.65}, {0.47, 3.90}, {0.49, 4.15}, {0.55, 4.34}, {0.66, 4.46}, {0.72, 4.53}, {0.72, 4.60},
        {0.66, 4.63}
    };

    /** From the lip down to the floor inside. */
    private static final double[][] INSIDE = {
        {0.66, 4.63},
        {0.60, 4.58},
        {0.52, 4.42},
        {0.44, 4.22},
        {0.40, 3.90},
        {0.42, 3.62},
        {0.55, 3.36},
        {0.94, 3.02},
        {1.20, 2.60},
        {1.27, 2.30},
        {1.16, 1.70},
        {0.90, 1.12},
        {0.55, 0.62},
        {0.20, 0.42}
    };

    /** The centre line of a handle in the plane of the axis, from inside the neck to inside the shoulder. */
    private static final double[][] HANDLE = {
        {0.36, 4.12},
        {0.52, 4.20},
        {0.72, 4.33},
        {0.96, 4.36},
        {1.14, 4.22},
        {1.20, 3.92},
        {1.16, 3.56},
        {1.10, 3.22},
        {1.04, 2.94},
        {0.98, 2.74}
    };

    private static final String MATERIAL = """
            # Fired clay, painted with slip.
            newmtl clay
            Kd 1 1 1
            Ks 0.12 0.12 0.12
            Ns 24
            map_Kd amphora.png
            """;

    private final ObjText obj = new ObjText("amphora", "amphora.mtl");

    private Amphora() {}

    static byte[] mtl() {
        return MATERIAL.getBytes(StandardCharsets.US_ASCII);
    }

    static byte[] obj() {
        Amphora amphora = new Amphora();
        amphora.obj.object("vessel", "clay");
        amphora.turned(curve(WALL, STEPS_PER_SPAN), AmphoraPainting.WALL_FROM + 0.002, 0.999);
        amphora.turned(curve(INSIDE, 1), 0.075, 0.13);
        amphora.floor();
        amphora.obj.object("handles", "clay");
        amphora.handle(1, 0.01);
        amphora.handle(-1, 0.51);
        return amphora.obj.toBytes();
    }

    /** A Catmull-Rom spline through the points. */
    private static List<double[]> curve(double[][] points, int steps) {
        List<double[]> curve = new ArrayList<>();
        for (int i = 0; i + 1 < points.length; i++) {
            double[] a = points[StrictMath.max(i - 1, 0)];
            double[] b = points[i];
            double[] c = points[i + 1];
            double[] d = points[StrictMath.min(i + 2, points.length - 1)];
            for (int k = 0; k < steps; k++) {
                double t = (double) k / steps;
                double[] p = new double[2];
                for (int j = 0; j < 2; j++) {
                    double m = 0.5 * (c[j] - a[j]);
                    double n = 0.5 * (d[j] - b[j]);
                    double bend = 2 * (b[j] - c[j]) + m + n;
                    p[j] = b[j] + t * (m + t * (3 * (c[j] - b[j]) - 2 * m - n + t * bend));
                }
                curve.add(p);
            }
        }
        curve.add(points[points.length - 1]);
        return curve;
    }

    /** Turns a profile about the y axis; the texture goes around once, v follows the length of the profile. */
    private void turned(List<double[]> profile, double fromV, double toV) {
        double[] length = lengths(profile);
        int rows = profile.size();
        int[] p = new int[rows * (SECTORS + 1)];
        int[] uv = new int[p.length];
        for (int row = 0; row < rows; row++) {
            double v = Blend.mix(fromV, toV, length[row] / length[rows - 1]);
            for (int s = 0; s <= SECTORS; s++) {
                double angle = 2 * StrictMath.PI * (s % SECTORS) / SECTORS;
                double radius = profile.get(row)[0];
                int at = row * (SECTORS + 1) + s;
                p[at] = obj.position(
                        radius * StrictMath.sin(angle), profile.get(row)[1], radius * StrictMath.cos(angle));
                uv[at] = obj.coordinate((double) s / SECTORS, v);
            }
        }
        for (int row = 0; row + 1 < rows; row++) {
            for (int s = 0; s < SECTORS; s++) quad(p, uv, row * (SECTORS + 1) + s, SECTORS + 1, (row + s) % 2 == 0);
        }
    }

    /** The quad at this corner of a grid, and its neighbours on the right and above. */
    private void quad(int[] p, int[] uv, int a, int stride, boolean rising) {
        int b = a + 1;
        int c = a + stride + 1;
        int d = a + stride;
        if (rising) {
            triangle(p, uv, a, b, c);
            triangle(p, uv, a, c, d);
        } else {
            triangle(p, uv, b, c, d);
            triangle(p, uv, b, d, a);
        }
    }

    private void triangle(int[] p, int[] uv, int a, int b, int c) {
        obj.triangle(new int[] {p[a], p[b], p[c]}, new int[] {uv[a], uv[b], uv[c]}, null);
    }

    private static double[] lengths(List<double[]> profile) {
        double[] length = new double[profile.size()];
        for (int i = 1; i < length.length; i++) {
            double dx = profile.get(i)[0] - profile.get(i - 1)[0];
            double dy = profile.get(i)[1] - profile.get(i - 1)[1];
            length[i] = length[i - 1] + StrictMath.sqrt(dx * dx + dy * dy);
        }
        return length;
    }

    /** Closes the foot below and the floor inside with fans. */
    private void floor() {
        fan(0.30, 0.05, 0.07, false);
        fan(0.20, 0.42, 0.40, true);
    }

    private void fan(double radius, double height, double middle, boolean up) {
        int[] centre = {obj.position(0, middle, 0), obj.coordinate(0.5, 0.035)};
        for (int s = 0; s < SECTORS; s++) {
            int[] a = rim(radius, height, s);
            int[] b = rim(radius, height, (s + 1) % SECTORS);
            int[] from = up ? a : b;
            int[] to = up ? b : a;
            obj.triangle(new int[] {from[0], to[0], centre[0]}, new int[] {from[1], to[1], centre[1]}, null);
        }
    }

    private int[] rim(double radius, double height, int sector) {
        double angle = 2 * StrictMath.PI * sector / SECTORS;
        double x = StrictMath.sin(angle);
        double z = StrictMath.cos(angle);
        return new int[] {obj.position(radius * x, height, radius * z), obj.coordinate(0.5 + 0.02 * x, 0.035 + 0.03 * z)
        };
    }

    /** A strap with a round section, wider than thick, closed at both ends, which are inside the wall. */
    private void handle(int side, double fromU) {
        List<double[]> line = curve(HANDLE, 4);
        double[] length = lengths(line);
        int rows = line.size();
        int around = 18;
        int[] p = new int[rows * (around + 1)];
        int[] uv = new int[p.length];
        for (int row = 0; row < rows; row++) {
            double[] before = line.get(StrictMath.max(row - 1, 0));
            double[] after = line.get(StrictMath.min(row + 1, rows - 1));
            double tx = after[0] - before[0];
            double ty = after[1] - before[1];
            double t = StrictMath.sqrt(tx * tx + ty * ty);
            for (int s = 0; s <= around; s++) {
                double angle = 2 * StrictMath.PI * (s % around) / around;
                double thick = 0.075 * StrictMath.sin(angle);
                double wide = 0.15 * StrictMath.cos(angle);
                double radius = line.get(row)[0] - thick * ty / t;
                double height = line.get(row)[1] + thick * tx / t;
                int at = row * (around + 1) + s;
                p[at] = obj.position(side * radius, height, -side * wide);
                uv[at] = obj.coordinate(fromU + 0.44 * length[row] / length[rows - 1], 0.005 + 0.06 * s / around);
            }
        }
        for (int row = 0; row + 1 < rows; row++) {
            for (int s = 0; s < around; s++) quad(p, uv, row * (around + 1) + s, around + 1, (row + s) % 2 == 0);
        }
    }
}
