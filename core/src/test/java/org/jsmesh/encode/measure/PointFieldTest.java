package org.jsmesh.encode.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.jsmesh.mesh.TriangleDistance;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PointFieldTest {
    private static final int POINTS = 2100;

    /** Triangles with one edge in common, each of which is close to every point. */
    private static float[] book(int n) {
        float[] p = new float[3 * (n + 2)];
        p[5] = 1;
        for (int i = 0; i < n; i++) {
            p[3 * i + 6] = (float) Math.cos(6.28 * i / n);
            p[3 * i + 7] = (float) Math.sin(6.28 * i / n);
            p[3 * i + 8] = .5f;
        }
        return p;
    }

    private static int[] pages(int n) {
        int[] triangles = new int[3 * n];
        Arrays.setAll(triangles, i -> i % 3 < 2 ? i % 3 : 2 + i / 3);
        return triangles;
    }

    private static double[] points() {
        Random random = new Random(1);
        return random.doubles(3 * POINTS, -1, 1).toArray();
    }

    private static double nearest(float[] p, int[] triangles, double[] points, int point) {
        double least = Double.POSITIVE_INFINITY;
        for (int t = 0; t < triangles.length; t += 3) {
            double d = TriangleDistance.squared(
                    p,
                    3 * triangles[t],
                    3 * triangles[t + 1],
                    3 * triangles[t + 2],
                    points[3 * point],
                    points[3 * point + 1],
                    points[3 * point + 2]);
            least = Math.min(least, d);
        }
        return Math.sqrt(least);
    }

    @Test
    void shouldFindTheLeastDistances() {
        float[] p = book(200);
        PointField field = new PointField(points(), true);
        field.measure(p, pages(200), 1);
        for (int i = 0; i < POINTS; i += 7)
            assertThat(field.distances()[i]).isEqualTo(nearest(p, pages(200), field.points(), i));
    }

    /** Every point would be compared with every triangle: 126 million pairs of the least, 504 million of the most. */
    @ParameterizedTest
    @ValueSource(ints = {60_000, 120_000, 240_000})
    void shouldNotCompareEveryPointWithEveryTriangle(int n) {
        float[] p = book(n);
        int[] triangles = pages(n);
        PointField field = new PointField(points(), true);
        field.measure(p, triangles, 1);
        assertThat(field.comparisons()).isLessThan((1 << 24) + 70L * (POINTS + n));
        for (int i = 0; i < POINTS; i += 300) {
            double least = nearest(p, triangles, field.points(), i);
            assertThat(field.distances()[i]).isBetween(least, least + .02);
        }
        field.measureMoved((vertex, axis) -> 2 * p[3 * vertex + axis], 1);
        for (int t = 0; t < p.length; t++) p[t] *= 2;
        for (int i = 0; i < POINTS; i += 300) {
            double least = nearest(p, triangles, field.points(), i);
            assertThat(field.distances()[i]).isBetween(least, least + .04);
        }
    }
}
