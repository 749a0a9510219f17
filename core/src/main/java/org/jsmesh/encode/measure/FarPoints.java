package org.jsmesh.encode.measure;

import java.util.Arrays;

/**
 * Finds the distance from a surface below which nearly all of the original lies. Few of the points tell, so it takes
 * more of them than the mean does. Only those that are far are measured: for the others it is enough to meet a triangle
 * that is close.
 */
final class FarPoints {
    /** Share of the surface that may be further away. */
    private static final double BEYOND = 0.001;

    /** One of so many points is further away than those for which a close triangle is enough. */
    private static final int FAR = 25;

    private static final int MOST_POINTS = 20_000;

    /** Faces of the original for each point. With more points, measuring them would be felt. */
    private static final int FACES_PER_POINT = 30;

    /** Of levels with fewer faces, distances change so little from face to face that the points of the mean tell. */
    private static final int FEW_FACES = 2000;

    private final PointField field; // or null

    FarPoints(SurfacePoints original, int faces) {
        int count = Math.min(MOST_POINTS, faces / FACES_PER_POINT);
        field = faces < FEW_FACES ? null : new PointField(original.strew(count));
    }

    /**
     * Finds the quantile of a level.
     *
     * @param sorted distances of other points from it
     */
    double quantile(float[] positions, int[] triangles, double[] sorted) {
        if (field == null || triangles.length < 3 * FEW_FACES) return quantile(sorted);
        double close = far(sorted);
        field.isCloseWithin(close);
        field.measure(positions, triangles, 1);
        field.forget();
        double[] all = Arrays.copyOf(sorted, sorted.length + field.size());
        System.arraycopy(field.distances(), 0, all, sorted.length, field.size());
        Arrays.sort(all);
        return quantile(all);
    }

    /**
     * The distance that all but a share of {@link #BEYOND} do not exceed, or a larger one where few points tell: by
     * half of what their number is off by on average.
     */
    static double quantile(double[] sorted) {
        double beyond = BEYOND * sorted.length;
        return sorted[sorted.length - Math.max(1, (int) (beyond - Math.sqrt(beyond) / 2))];
    }

    /** A distance that one of {@link #FAR} exceeds. */
    static double far(double[] sorted) {
        return sorted[sorted.length - 1 - sorted.length / FAR];
    }

    static double[] sorted(double[] distances, int from, int to) {
        double[] sorted = Arrays.copyOfRange(distances, from, to);
        Arrays.sort(sorted);
        return sorted;
    }
}
