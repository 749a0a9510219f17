package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class MemorylessQuadricTest {
    @Test
    void shouldEqualTheSumOverTheFaces() {
        Random random = new Random(7);
        MemorylessQuadric quadric = new MemorylessQuadric();
        for (int round = 0; round < 20; round++) {
            double[] d = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
            double gathered = random.nextDouble();
            double squares = 0;
            double volume = 0;
            double area = 0;
            quadric.clear();
            for (int f = 0; f < 6; f++) {
                double[] n = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
                double length = Math.sqrt(dot(n, n));
                quadric.addFace(n[0], n[1], n[2], length);
                double distance = dot(n, d) / length;
                squares += length / 2 * distance * distance;
                volume += length / 2 * distance;
                area += length / 2;
            }
            double expected = squares + 0.5 * volume * volume / area + 1e-7 * gathered * dot(d, d);
            assertThat(quadric.cost(d[0], d[1], d[2], gathered)).isCloseTo(expected, within(1e-9 * expected));
            assertThat(quadric.area()).isCloseTo(area, within(1e-12));
        }
    }

    @Test
    void shouldCostOnlyLengthInAPlane() {
        MemorylessQuadric quadric = new MemorylessQuadric();
        quadric.addFace(0, 0, 2, 2);
        quadric.addFace(0, 0, 1, 1);
        assertThat(quadric.cost(3, 4, 0, 2)).isCloseTo(1e-7 * 2 * 25, within(1e-18));
    }

    @Test
    void shouldCostNoPlaneWithoutArea() {
        assertThat(new MemorylessQuadric().cost(1, 0, 0, 0)).isZero();
    }

    @Test
    void shouldCostTheDistanceFromAFeatureTimesItsLength() {
        // edge of length 2 along x, move by 3 across and any way along
        assertThat(MemorylessQuadric.featureCost(2, 0, 0, 5, 0, 3)).isCloseTo(0.2 * 4 * 9, within(1e-12));
        assertThat(MemorylessQuadric.featureCost(2, 0, 0, -5, 0, 0)).isZero();
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
