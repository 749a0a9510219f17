package org.jsmesh.encode.measure;

import java.util.Arrays;
import org.jsmesh.codec.lod.LodSurface;
import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.TriangleDistance;

/**
 * Measures distances from points to one surface after the other. It goes through each surface once, triangle by
 * triangle; a grid gives the points that a triangle may be closest to. This takes time in proportion to points and
 * triangles, and less time than sorting the triangles. The surface before tells how far to look; afterwards the field
 * checks that it was enough.
 *
 * <p>Where triangles overlap as those about an edge of thousands do, every point may be close to every triangle. After
 * some work for each point and triangle the field gives that up and asks a {@link CrowdedSurface}.
 */
final class PointField {
    /**
     * Points that are more than this many times further away from a surface than from the one before are looked for
     * again.
     */
    private static final double GROWTH = 3;

    private static final int EDGES = 200; // triangles whose sides tell how large all are

    /** Least reach, in parts of the points' extent. A smaller one saves nothing. */
    private static final double LEAST_REACH = 1e-4;

    /** Work that any surface may take, in comparisons of a point with a triangle's box. */
    private static final long FEW_COMPARISONS = 1 << 23;

    /** The same for each point and each triangle. */
    private static final int MOST_COMPARISONS = 64;

    /** Pairs that are kept for each point. Ordinary surfaces have a dozen. */
    private static final int MOST_PAIRS = 256;

    private final double[] points;
    private final boolean keepsPairs;
    private final double leastReach;
    private final double[] distances; // last measured
    private final double[] reach;
    private final double[] squares;
    private final int[] nearest; // three times the triangle, or negative
    private final int[] seenBy; // triangle that was compared last
    private int[] near = new int[64]; // pairs of point and triangle that were compared
    private int pairs; // −1 when they are too many to keep
    private int[] triangles; // last measured
    private long comparisons;
    private double close = -1; // squared, negative when all distances count

    /** Whether surfaces are taken for crowded from now on. */
    boolean isCrowded;

    /** @param points x, y, z of each */
    PointField(double[] points) {
        this(points, false);
    }

    /** @param keepsPairs whether surfaces are measured again after they have moved */
    PointField(double[] points, boolean keepsPairs) {
        this.points = points;
        this.keepsPairs = keepsPairs;
        int n = points.length / 3;
        distances = new double[n];
        reach = new double[n];
        squares = new double[n];
        nearest = new int[n];
        seenBy = new int[n];
        leastReach = LEAST_REACH * PointGrid.extent(points);
    }

    double[] points() {
        return points;
    }

    int size() {
        return distances.length;
    }

    /** Distances of the points measured last, 0 at first. */
    double[] distances() {
        return distances;
    }

    /** Comparisons of points with triangles, and looks into cells, that the last surface took without a tree. */
    long comparisons() {
        return comparisons;
    }

    /** Three times the number of the triangle that is closest to each point measured last. */
    int[] nearest() {
        return nearest;
    }

    /** From now on, distances up to this one are only known not to exceed it. */
    void isCloseWithin(double distance) {
        close = distance * distance;
    }

    /**
     * Measures the distances of every {@code step}-th point from a surface with at least one triangle.
     *
     * @param triangles if this is the very array of the last call, the surface has only moved, and the closest
     *     triangles are likely to be the same
     */
    void measure(float[] positions, int[] triangles, int step) {
        if (isCrowded) measureCrowded(positions, triangles, step);
        else measureAll(positions, triangles, step);
    }

    /** Forgets the surface measured last, which can then not be measured again after it has moved. */
    void forget() {
        triangles = null;
    }

    private void measureAll(float[] positions, int[] triangles, int step) {
        // triangles that are large beside the distances between points are mostly far closer than their size
        double share = Math.min(1, Math.sqrt(triangles.length / 3.0 / size() * step));
        double least = close >= 0 ? Math.sqrt(close) : edge(positions, triangles) / 2 * share;
        boolean again = this.triangles == triangles; // and all points have been measured
        this.triangles = triangles;
        pairs = keepsPairs ? 0 : -1;
        comparisons = 0;
        int[] open = new int[(size() + step - 1) / step];
        for (int i = 0; i < open.length; i++) {
            int point = open[i] = i * step;
            double expected = close >= 0 ? 0 : GROWTH * distances[point];
            reach[point] = again
                    ? distanceFrom(positions, nearest[point], point)
                    : Math.max(leastReach, Math.max(least, expected));
        }
        while (open.length > 0) {
            for (int i : open) {
                squares[i] = reach[i] * reach[i];
                if (!again) nearest[i] = -1;
                seenBy[i] = -1;
            }
            if (!compare(positions, triangles, new PointGrid(points, open, reach))) {
                measureCrowded(positions, triangles, step);
                return;
            }
            int left = 0;
            for (int i : open) {
                distances[i] = Math.sqrt(squares[i]);
                if (nearest[i] >= 0) continue;
                reach[i] *= 4;
                open[left++] = i;
            }
            open = Arrays.copyOf(open, left);
        }
    }

    private void measureCrowded(float[] positions, int[] triangles, int step) {
        isCrowded = true;
        pairs = -1;
        this.triangles = triangles;
        CrowdedSurface surface = new CrowdedSurface(positions, triangles);
        for (int i = 0; i < size(); i += step) {
            int at = 3 * i;
            squares[i] = surface.squaredDistance(points[at], points[at + 1], points[at + 2]);
            distances[i] = Math.sqrt(squares[i]);
            nearest[i] = surface.triangle();
        }
    }

    private double distanceFrom(float[] p, int triangle, int point) {
        int at = 3 * point;
        return Math.sqrt(TriangleDistance.squared(
                p,
                3 * triangles[triangle],
                3 * triangles[triangle + 1],
                3 * triangles[triangle + 2],
                points[at],
                points[at + 1],
                points[at + 2]));
    }

    /**
     * Measures every {@code step}-th point again, from the triangles that were near, after their vertices have moved by
     * less than the points' reach.
     */
    void measureMoved(LodSurface.Places places, int step) {
        if (pairs < 0) {
            int vertices = 0;
            for (int v : triangles) vertices = Math.max(vertices, v + 1);
            float[] positions = new float[3 * vertices];
            for (int v : triangles) for (int a = 0; a < 3; a++) positions[3 * v + a] = (float) places.coordinate(v, a);
            measureCrowded(positions, triangles, step);
            return;
        }
        Arrays.fill(squares, Double.POSITIVE_INFINITY);
        float[] corners = new float[9];
        for (int i = 0; i < 2 * pairs; i += 2) {
            int point = near[i];
            if (point % step != 0) continue;
            for (int k = 0; k < 9; k++) corners[k] = (float) places.coordinate(triangles[near[i + 1] + k / 3], k % 3);
            double d = TriangleDistance.squared(
                    corners, 0, 3, 6, points[3 * point], points[3 * point + 1], points[3 * point + 2]);
            if (d >= squares[point]) continue;
            squares[point] = d;
            nearest[point] = near[i + 1];
        }
        for (int i = 0; i < size(); i += step) distances[i] = Math.sqrt(squares[i]);
    }

    /** The mean length of the longest sides of some triangles' boxes. */
    private static double edge(float[] p, int[] triangles) {
        int faces = triangles.length / 3;
        int n = Math.min(EDGES, faces);
        double sum = 0;
        for (int i = 0; i < n; i++) {
            int t = 3 * (int) ((long) i * faces / n);
            double longest = 0;
            for (int axis = 0; axis < 3; axis++) {
                double a = p[3 * triangles[t] + axis];
                double b = p[3 * triangles[t + 1] + axis];
                double c = p[3 * triangles[t + 2] + axis];
                longest = Math.max(longest, Math.max(a, Math.max(b, c)) - Math.min(a, Math.min(b, c)));
            }
            sum += longest;
        }
        return sum / n;
    }

    /** Compares points with triangles. False when that is too much work, and points have not met all triangles. */
    private boolean compare(float[] p, int[] triangles, PointGrid grid) {
        int[] starts = grid.starts();
        long most = FEW_COMPARISONS + MOST_COMPARISONS * (size() + triangles.length / 3L);
        for (int t = 0; t < triangles.length; t += 3) {
            int a = 3 * triangles[t];
            int b = 3 * triangles[t + 1];
            int c = 3 * triangles[t + 2];
            float lowX = Math.min(p[a], Math.min(p[b], p[c]));
            float highX = Math.max(p[a], Math.max(p[b], p[c]));
            float lowY = Math.min(p[a + 1], Math.min(p[b + 1], p[c + 1]));
            float highY = Math.max(p[a + 1], Math.max(p[b + 1], p[c + 1]));
            float lowZ = Math.min(p[a + 2], Math.min(p[b + 2], p[c + 2]));
            float highZ = Math.max(p[a + 2], Math.max(p[b + 2], p[c + 2]));
            int x0 = grid.first(0, lowX);
            int x1 = grid.last(0, highX);
            int y0 = grid.first(1, lowY);
            int y1 = grid.last(1, highY);
            int z1 = grid.last(2, highZ);
            if (comparisons > most) return false;
            comparisons++;
            double ux = p[b] - p[a];
            double uy = p[b + 1] - p[a + 1];
            double uz = p[b + 2] - p[a + 2];
            double vx = p[c] - p[a];
            double vy = p[c + 1] - p[a + 1];
            double vz = p[c + 2] - p[a + 2];
            double nx = uy * vz - uz * vy;
            double ny = uz * vx - ux * vz;
            double nz = ux * vy - uy * vx;
            double nn = (nx * nx + ny * ny + nz * nz) * (1 + 1e-6); // rounding must not rule out the closest one
            for (int z = grid.first(2, lowZ); z <= z1; z++) {
                for (int y = y0; y <= y1; y++) {
                    int from = starts[grid.cell(x0, y, z)];
                    int to = x1 < x0 ? from : starts[grid.cell(x1, y, z) + 1];
                    // cells along x follow each other
                    comparisons += 1 + Math.max(0, to - from);
                    for (int i = from; i < to; i++) {
                        int point = grid.items()[i];
                        if (seenBy[point] == t || squares[point] <= close && nearest[point] >= 0) continue;
                        seenBy[point] = t;
                        double x = points[3 * point];
                        double px = points[3 * point + 1];
                        double pz = points[3 * point + 2];
                        double dx = Math.max(0, Math.max(lowX - x, x - highX));
                        double dy = Math.max(0, Math.max(lowY - px, px - highY));
                        double dz = Math.max(0, Math.max(lowZ - pz, pz - highZ));
                        if (dx * dx + dy * dy + dz * dz > squares[point]) continue;
                        double height = (x - p[a]) * nx + (px - p[a + 1]) * ny + (pz - p[a + 2]) * nz;
                        if (height * height > squares[point] * nn) continue;
                        if (pairs >= 0) keep(point, t);
                        double d = TriangleDistance.squared(p, a, b, c, x, px, pz);
                        if (d > squares[point] || d == squares[point] && nearest[point] >= 0) continue;
                        squares[point] = d;
                        nearest[point] = t;
                    }
                }
            }
        }
        return true;
    }

    private void keep(int point, int triangle) {
        if (pairs >= Math.min(MOST_PAIRS * (long) size(), Sizes.MOST / 2)) {
            pairs = -1;
            return;
        }
        if (2 * pairs == near.length) near = Arrays.copyOf(near, Sizes.grown(near.length, "pairs") & -2);
        near[2 * pairs] = point;
        near[2 * pairs++ + 1] = triangle;
    }
}
