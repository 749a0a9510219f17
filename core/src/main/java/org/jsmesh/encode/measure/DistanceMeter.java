package org.jsmesh.encode.measure;

import org.jsmesh.mesh.Mesh;

/**
 * Measures how far levels of detail are from their original: exact distances from points of each surface to the
 * triangles of the other, as Metro does (Cignoni, Rocchini, Scopigno 1998). Points are spread evenly over the area for
 * the mean; vertices count for the maximum too. Deterministic and thread-safe.
 */
public final class DistanceMeter {
    private static final int SAMPLES = 10_000;

    /**
     * Most vertices per sample that are looked at for the maximum. Most of them cost no more than one distance to a
     * triangle.
     */
    private static final int VERTICES_PER_SAMPLE = 4;

    private final int samples;
    private final double diagonal;
    private final TriangleTree tree;
    private final double[] points;

    /**
     * How far two surfaces are from each other, in % of the diagonal of the original's bounding box.
     *
     * @param mean of the distances from either surface to the other; both directions have the same weight
     * @param maximum of the distances measured: a lower bound of the Hausdorff distance
     */
    public record Distance(double mean, double maximum) {}

    public DistanceMeter(Mesh original) {
        this(original, SAMPLES);
    }

    /**
     * @param samples points on each surface
     * @throws IllegalArgumentException when the original has no face
     */
    public DistanceMeter(Mesh original, int samples) {
        if (samples < 1) throw new IllegalArgumentException(samples + " samples");
        this.samples = samples;
        int[] triangles = new int[3 * original.faces()];
        for (int i = 0; i < triangles.length; i++) triangles[i] = original.wedgeVertices()[original.faceWedges()[i]];
        tree = new TriangleTree(original.positions(), triangles, original.faces());
        points = tree.surface().strew(samples);
        diagonal = diagonal(tree.corners());
    }

    /** The original's triangles. */
    TriangleTree tree() {
        return tree;
    }

    /**
     * Measures a level of detail.
     *
     * @param positions x, y, z of its vertices
     * @param triangles three vertices per face
     * @param faces of it, at least one
     */
    public Distance measure(float[] positions, int[] triangles, int faces) {
        return measure(new TriangleTree(positions, triangles, faces), true);
    }

    /** Measures the mean alone, in half the time of {@link #measure}. */
    public double mean(float[] positions, int[] triangles, int faces) {
        return measure(new TriangleTree(positions, triangles, faces), false).mean();
    }

    /**
     * Measures single points.
     *
     * @param points x, y, z of each, in units of the model
     * @return their distances to the surface, in units of the model
     */
    public float[] distances(float[] points) {
        TriangleTree.Cursor cursor = new TriangleTree.Cursor(tree);
        float[] distances = new float[points.length / 3];
        for (int i = 0; i < distances.length; i++)
            distances[i] =
                    (float) Math.sqrt(cursor.squaredDistance(points[3 * i], points[3 * i + 1], points[3 * i + 2]));
        return distances;
    }

    private Distance measure(TriangleTree other, boolean withVertices) {
        Sweep there = new Sweep(other);
        there.addPoints(points);
        if (withVertices) there.addVertices(tree.vertices());
        Sweep back = new Sweep(tree);
        back.largest = there.largest;
        back.addPoints(other.surface().strew(samples));
        if (withVertices) back.addVertices(other.vertices());
        double percent = diagonal > 0 ? 100 / diagonal : 0;
        return new Distance((there.sum + back.sum) / (2 * samples) * percent, Math.sqrt(back.largest) * percent);
    }

    private static double diagonal(float[] corners) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < corners.length; i += 3) {
                low = Math.min(low, corners[i]);
                high = Math.max(high, corners[i]);
            }
            sum += (high - low) * (high - low);
        }
        return Math.sqrt(sum);
    }

    /** Distances from many points to one surface. */
    private final class Sweep {
        private final TriangleTree.Cursor cursor;
        private double sum;
        private double largest; // squared

        Sweep(TriangleTree surface) {
            cursor = new TriangleTree.Cursor(surface);
        }

        void addPoints(double[] p) {
            for (int i = 0; i < p.length; i += 3) {
                double d = cursor.squaredDistance(p[i], p[i + 1], p[i + 2]);
                sum += Math.sqrt(d);
                largest = Math.max(largest, d);
            }
        }

        void addVertices(float[] p) {
            int step = 3 * Math.max(1, p.length / 3 / (VERTICES_PER_SAMPLE * samples));
            for (int i = 0; i < p.length; i += step) {
                largest = Math.max(largest, cursor.squaredDistance(p[i], p[i + 1], p[i + 2], largest));
            }
        }
    }
}
