package org.jsmesh.samples;

import java.util.ArrayList;
import java.util.List;

/** One arm of the octopus: a tapering tube along a curve, with two rows of suckers below. */
final class Arm {
    private static final int SEGMENTS = 96;
    private static final int CHUNK = 6;
    private static final double FINEST_HOLE = 0.04;

    /**
     * The shape of an arm's curve. Angles in radians; the pitch is upwards, the yaw counter-clockwise seen from below.
     */
    record Pose(
            double azimuth,
            double length,
            double sway,
            double swayPhase,
            double curlStart,
            double curlUp,
            double curlSide) {}

    private record Sucker(double[] centre, double[] outward, double radius, int segment) {}

    private final Pose pose;
    private final double[][] curve = new double[SEGMENTS + 1][];
    private final double[][] dorsal = new double[SEGMENTS + 1][];
    private final double[][] side = new double[SEGMENTS + 1][];
    private final double[] chunkRadius = new double[SEGMENTS / CHUNK];
    private final Sucker[] suckers;
    private final double[] low = {9, 9, 9};
    private final double[] high = {-9, -9, -9};

    /**
     * Of the last point asked for: nearest place on the curve from 0 to 1, how far below the arm (−1 above, 1 below),
     * and the nearest sucker's centre.
     */
    double place;

    double below;
    double suckerDistance;

    Arm(Pose pose) {
        this.pose = pose;
        double steep = 0;
        double flat = 3;
        // The steeper it dives, the lower it lies: halve the interval until the arm rests on the ground.
        for (int i = 0; i < 40; i++) {
            double dive = 0.5 * (steep + flat);
            trace(dive);
            if (lowest() < 0) flat = dive;
            else steep = dive;
        }
        for (double[] p : curve) {
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = StrictMath.min(low[axis], p[axis]);
                high[axis] = StrictMath.max(high[axis], p[axis]);
            }
        }
        for (int c = 0; c < chunkRadius.length; c++) {
            double[] centre = curve[c * CHUNK + CHUNK / 2];
            for (int i = c * CHUNK; i <= (c + 1) * CHUNK; i++) {
                chunkRadius[c] = StrictMath.max(chunkRadius[c], distance(curve[i], centre) + 1.4 * radius(i));
            }
        }
        suckers = placeSuckers();
    }

    private static double radius(double i) {
        double t = i / SEGMENTS;
        return 0.024 + 0.17 * StrictMath.pow(StrictMath.max(1 - t, 0), 1.25);
    }

    private void trace(double dive) {
        double ds = pose.length / SEGMENTS;
        double x = 0.2 * StrictMath.cos(pose.azimuth);
        double y = 0.44;
        double z = 0.2 * StrictMath.sin(pose.azimuth);
        for (int i = 0; i <= SEGMENTS; i++) {
            double t = (double) i / SEGMENTS;
            double curl = StrictMath.max(0, (t - pose.curlStart) / (1 - pose.curlStart));
            curl = curl * StrictMath.sqrt(curl);
            double pitch = -dive * bump((t - 0.02) / 0.42) + pose.curlUp * curl;
            double yaw = pose.azimuth
                    + pose.sway * smooth(t / 0.3) * StrictMath.sin(pose.swayPhase + 5.2 * t)
                    + pose.curlSide * curl;
            double cp = StrictMath.cos(pitch);
            double sp = StrictMath.sin(pitch);
            double cy = StrictMath.cos(yaw);
            double sy = StrictMath.sin(yaw);
            curve[i] = new double[] {x, y, z};
            dorsal[i] = new double[] {-sp * cy, cp, -sp * sy};
            side[i] = new double[] {-sy, 0, cy};
            x += ds * cp * cy;
            y += ds * sp;
            z += ds * cp * sy;
        }
    }

    private double lowest() {
        double lowest = 1;
        for (int i = 0; i <= SEGMENTS; i++) lowest = StrictMath.min(lowest, curve[i][1] - radius(i));
        return lowest;
    }

    private Sucker[] placeSuckers() {
        List<Sucker> placed = new ArrayList<>();
        double ds = pose.length / SEGMENTS;
        double next = 0.16 * pose.length;
        for (int i = 0; i < SEGMENTS * 0.9; i++) {
            if (i * ds < next) continue;
            double r = radius(i);
            for (int row = -1; row <= 1; row += 2) {
                double[] outward = new double[3];
                double[] centre = new double[3];
                for (int a = 0; a < 3; a++) {
                    outward[a] = -0.85 * dorsal[i][a] + 0.527 * row * side[i][a];
                    centre[a] = curve[i][a] + r * outward[a];
                }
                placed.add(new Sucker(centre, outward, 0.4 * r + 0.006, i));
            }
            next = i * ds + 0.98 * r + 0.014;
        }
        return placed.toArray(Sucker[]::new);
    }

    /** Distance to the arm, at most {@code far}; sets the fields that tell where. */
    double distance(double x, double y, double z, double far) {
        double best = far;
        int nearest = -1;
        suckerDistance = 9;
        below = 0;
        place = 0;
        double along = 0;
        if (isBeyond(x, y, z, far)) return far;
        for (int c = 0; c < chunkRadius.length; c++) {
            double[] centre = curve[c * CHUNK + CHUNK / 2];
            double reach = best + chunkRadius[c];
            double dx = x - centre[0];
            double dy = y - centre[1];
            double dz = z - centre[2];
            if (reach <= 0 || dx * dx + dy * dy + dz * dz > reach * reach) continue;
            for (int i = c * CHUNK; i < (c + 1) * CHUNK; i++) {
                double[] a = curve[i];
                double[] b = curve[i + 1];
                double ux = b[0] - a[0];
                double uy = b[1] - a[1];
                double uz = b[2] - a[2];
                double t = ((x - a[0]) * ux + (y - a[1]) * uy + (z - a[2]) * uz) / (ux * ux + uy * uy + uz * uz);
                t = StrictMath.max(0, StrictMath.min(1, t));
                double ex = x - a[0] - t * ux;
                double ey = y - a[1] - t * uy;
                double ez = z - a[2] - t * uz;
                double d = StrictMath.sqrt(ex * ex + ey * ey + ez * ez) - radius(i) * (1 - t) - radius(i + 1) * t;
                if (d < best) {
                    best = d;
                    nearest = i;
                    along = t;
                }
            }
        }
        if (nearest < 0) return best;
        place = (nearest + along) / SEGMENTS;
        double[] centre = curve[nearest];
        double[] up = dorsal[nearest];
        below = -((x - centre[0]) * up[0] + (y - centre[1]) * up[1] + (z - centre[2]) * up[2]) / radius(nearest);
        return best < 0.12 ? withSuckers(x, y, z, nearest, best) : best;
    }

    private boolean isBeyond(double x, double y, double z, double far) {
        double reach = far + 0.25;
        return x < low[0] - reach
                || y < low[1] - reach
                || z < low[2] - reach
                || x > high[0] + reach
                || y > high[1] + reach
                || z > high[2] + reach;
    }

    private double withSuckers(double x, double y, double z, int nearest, double d) {
        for (Sucker s : suckers) {
            if (StrictMath.abs(s.segment - nearest) > CHUNK) continue;
            double dx = x - s.centre[0];
            double dy = y - s.centre[1];
            double dz = z - s.centre[2];
            double length = StrictMath.sqrt(dx * dx + dy * dy + dz * dz);
            suckerDistance = StrictMath.min(suckerDistance, length / s.radius);
            if (length > 3 * s.radius) continue;
            d = Blend.union(d, length - s.radius, 0.35 * s.radius);
            // The smallest are bumps: a hole would be finer than the mesh.
            if (s.radius < FINEST_HOLE) continue;
            double out = 0.85 * s.radius;
            double hx = dx - out * s.outward[0];
            double hy = dy - out * s.outward[1];
            double hz = dz - out * s.outward[2];
            double hole = StrictMath.sqrt(hx * hx + hy * hy + hz * hz) - 0.66 * s.radius;
            d = -Blend.union(-d, hole, 0.2 * s.radius);
        }
        return d;
    }

    private static double bump(double t) {
        if (t <= 0 || t >= 1) return 0;
        double u = 4 * t * (1 - t);
        return u * u;
    }

    private static double smooth(double t) {
        double u = StrictMath.max(0, StrictMath.min(1, t));
        return u * u * (3 - 2 * u);
    }

    private static double distance(double[] a, double[] b) {
        double dx = a[0] - b[0];
        double dy = a[1] - b[1];
        double dz = a[2] - b[2];
        return StrictMath.sqrt(dx * dx + dy * dy + dz * dz);
    }
}
