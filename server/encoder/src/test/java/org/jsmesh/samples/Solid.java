package org.jsmesh.samples;

import java.util.ArrayList;
import java.util.List;

/**
 * A closed shape swept over loops around the z axis: neighbouring loops are joined by a band of triangles, whatever
 * their numbers of points. Going up on the outside, inwards over the top, down on the inside and outwards below makes
 * faces that look out.
 */
final class Solid {
    final List<double[]> points = new ArrayList<>();
    final List<int[]> triangles = new ArrayList<>();

    private int[] last;
    private int[] first;

    /** A point on a loop: distance from the axis, and angle. */
    record Polar(double radius, double angle) {}

    static List<Polar> circle(double radius, int count) {
        List<Polar> loop = new ArrayList<>();
        for (int i = 0; i < count; i++) loop.add(new Polar(radius, 2 * StrictMath.PI * i / count));
        return loop;
    }

    /** Continues with the loop at this height; the first call starts the shape. */
    Solid loop(List<Polar> loop, double z) {
        return loop(loop, z, 0);
    }

    /** As above, turned about the axis by {@code twist}. */
    Solid loop(List<Polar> loop, double z, double twist) {
        int[] ids = new int[loop.size()];
        for (int i = 0; i < ids.length; i++) {
            Polar p = loop.get(i);
            ids[i] = point(p.radius * StrictMath.cos(p.angle + twist), p.radius * StrictMath.sin(p.angle + twist), z);
        }
        if (last == null) first = ids;
        else band(last, ids);
        last = ids;
        return this;
    }

    /** Closes the last loop with a fan about a point on the axis. */
    Solid tip(double z) {
        int top = point(0, 0, z);
        for (int i = 0; i < last.length; i++) triangles.add(new int[] {last[i], last[(i + 1) % last.length], top});
        return this;
    }

    /** Closes the first loop with a fan about a point on the axis. */
    Solid bottom(double z) {
        int low = point(0, 0, z);
        for (int i = 0; i < first.length; i++) triangles.add(new int[] {first[(i + 1) % first.length], first[i], low});
        return this;
    }

    /** Joins the last loop to the first: the shape has a hole along the axis. */
    Solid ring() {
        band(last, first);
        return this;
    }

    /** Turned about the z axis, then moved. */
    Solid placed(double angle, double x, double y, double z) {
        double c = StrictMath.cos(angle);
        double s = StrictMath.sin(angle);
        Solid placed = new Solid();
        for (double[] p : points) placed.point(c * p[0] - s * p[1] + x, s * p[0] + c * p[1] + y, p[2] + z);
        placed.triangles.addAll(triangles);
        return placed;
    }

    private int point(double x, double y, double z) {
        points.add(new double[] {x, y, z});
        return points.size() - 1;
    }

    private void band(int[] from, int[] to) {
        if (from.length == to.length) {
            for (int i = 0; i < from.length; i++) {
                int next = (i + 1) % from.length;
                triangles.add(new int[] {from[i], from[next], to[next]});
                triangles.add(new int[] {from[i], to[next], to[i]});
            }
            return;
        }
        // Walk around both and advance the loop that lags behind.
        int j0 = nearest(to, angle(from[0]));
        double start = angle(from[0]);
        for (int i = 0, j = 0; i < from.length || j < to.length; ) {
            int a = from[i % from.length];
            int b = to[(j0 + j) % to.length];
            int nextA = from[(i + 1) % from.length];
            int nextB = to[(j0 + j + 1) % to.length];
            boolean advanceFrom = j == to.length
                    || i < from.length
                            && passed(nextA, start, i + 1, from.length) <= passed(nextB, start, j + 1, to.length);
            if (advanceFrom) {
                triangles.add(new int[] {a, nextA, b});
                i++;
            } else {
                triangles.add(new int[] {a, nextB, b});
                j++;
            }
        }
    }

    /**
     * How far around a point lies after {@code steps} of {@code count} points: its angle, in the turn that the steps
     * suggest.
     */
    private double passed(int point, double start, int steps, int count) {
        double expected = 2 * StrictMath.PI * steps / count;
        double turned = angle(point) - start;
        return turned + 2 * StrictMath.PI * StrictMath.rint((expected - turned) / (2 * StrictMath.PI));
    }

    private int nearest(int[] loop, double angle) {
        int best = 0;
        for (int i = 1; i < loop.length; i++) {
            if (apart(angle(loop[i]), angle) < apart(angle(loop[best]), angle)) best = i;
        }
        return best;
    }

    private static double apart(double a, double b) {
        double turn = (a - b) / (2 * StrictMath.PI);
        return StrictMath.abs(turn - StrictMath.rint(turn));
    }

    private double angle(int point) {
        double[] p = points.get(point);
        return StrictMath.atan2(p[1], p[0]);
    }
}
