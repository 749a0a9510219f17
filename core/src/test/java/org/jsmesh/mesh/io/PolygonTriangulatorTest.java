package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

class PolygonTriangulatorTest {
    private final IntList out = new IntList();

    /** @param xy coordinates in a tilted plane, so that no axis is special */
    private PolygonTriangulator.Cut cut(double... xy) {
        int corners = xy.length / 2;
        return new PolygonTriangulator(positions(xy)).cut(range(corners), 0, corners, out);
    }

    private static float[] positions(double... xy) {
        float[] positions = new float[xy.length / 2 * 3];
        for (int i = 0; i < xy.length / 2; i++) {
            positions[3 * i] = (float) xy[2 * i];
            positions[3 * i + 1] = (float) xy[2 * i + 1];
            positions[3 * i + 2] = (float) (xy[2 * i] + 2 * xy[2 * i + 1]);
        }
        return positions;
    }

    private static int[] range(int end) {
        return IntStream.range(0, end).toArray();
    }

    private double area(double... xy) {
        double sum = 0;
        for (int t = 0; t < out.size(); t += 3) {
            double twice = cross(xy, out.get(t), out.get(t + 1), out.get(t + 2));
            assertThat(twice).as("triangle %d is turned over", t / 3).isGreaterThanOrEqualTo(0);
            sum += twice / 2;
        }
        return sum;
    }

    private static double cross(double[] xy, int a, int b, int c) {
        return (xy[2 * b] - xy[2 * a]) * (xy[2 * c + 1] - xy[2 * a + 1])
                - (xy[2 * b + 1] - xy[2 * a + 1]) * (xy[2 * c] - xy[2 * a]);
    }

    @Test
    void shouldFanConvexPolygonsFromTheFirstCorner() {
        assertThat(cut(0, 0, 1, 0, 2, 1, 1, 2, 0, 1)).isEqualTo(PolygonTriangulator.Cut.FAN);
        assertThat(out.toArray()).startsWith(0, 1, 2, 0, 2, 3, 0, 3, 4);
    }

    @Test
    void shouldClipEarsOfConcavePolygons() {
        double[] arrow = {0, 0, 2, -1, 1, 0, 2, 1};
        assertThat(cut(arrow)).isEqualTo(PolygonTriangulator.Cut.EARS);
        assertThat(out.size()).isEqualTo(6);
        assertThat(area(arrow)).isEqualTo(1.0);
    }

    @Test
    void shouldCoverACombExactly() {
        int teeth = 40;
        double[] comb = new double[2 * (2 * teeth + 2)];
        int at = 0;
        comb[at++] = 0;
        comb[at++] = -1;
        comb[at++] = 2 * teeth;
        comb[at++] = -1;
        for (int i = 2 * teeth - 1; i >= 0; i--) {
            comb[at++] = i + .5;
            comb[at++] = i % 2 == 0 ? 0 : 5;
        }
        double expected = 0;
        for (int i = 0, j = comb.length / 2 - 1; i < comb.length / 2; j = i++)
            expected += (comb[2 * j] * comb[2 * i + 1] - comb[2 * i] * comb[2 * j + 1]) / 2;
        assertThat(cut(comb)).isEqualTo(PolygonTriangulator.Cut.EARS);
        assertThat(out.size()).isEqualTo(3 * (comb.length / 2 - 2));
        assertThat(area(comb)).isCloseTo(expected, org.assertj.core.data.Offset.offset(1e-9));
    }

    @Test
    void shouldFanPolygonsWithoutArea() {
        assertThat(cut(0, 0, 1, 1, 2, 2, 3, 3)).isEqualTo(PolygonTriangulator.Cut.FAN);
        assertThat(out.size()).isEqualTo(6);
    }

    @Test
    void shouldEndOnPolygonsThatCrossThemselves() {
        Random random = new Random(3);
        double[] xy = new double[2000];
        for (int i = 0; i < xy.length; i++) xy[i] = random.nextInt(100);
        cut(xy);
        assertThat(out.size()).isEqualTo(3 * (xy.length / 2 - 2));
    }

    /** Once the tests are spent, any corner goes; the next concave polygon is not even looked at. */
    @Test
    void shouldGiveUpOnPolygonsThatWouldTakeForever() {
        Random random = new Random(4);
        double[] xy = new double[400_000];
        for (int i = 0; i < xy.length; i++) xy[i] = random.nextDouble();
        PolygonTriangulator few = new PolygonTriangulator(positions(xy), 1_000_000, 4);
        int corners = xy.length / 2;
        assertThat(few.cut(range(corners), 0, corners, out)).isEqualTo(PolygonTriangulator.Cut.EARS);
        assertThat(out.size()).isEqualTo(3 * (corners - 2));
        assertThat(few.cut(range(corners), 0, 1000, out)).isEqualTo(PolygonTriangulator.Cut.GIVEN_UP);
        assertThat(out.size()).isEqualTo(3 * (corners - 2 + 1000 - 2));
    }

    @Tag("slow")
    @Tag("long")
    @Test
    void shouldGiveUpByItself() {
        Random random = new Random(4);
        double[] xy = new double[400_000];
        for (int i = 0; i < xy.length; i++) xy[i] = random.nextInt(9);
        int corners = xy.length / 2;
        PolygonTriangulator triangulator = new PolygonTriangulator(positions(xy));
        triangulator.cut(range(corners), 0, corners, out);
        assertThat(out.size()).isEqualTo(3 * (corners - 2));
        assertThat(triangulator.tests()).isLessThan(110_000_000 + 1024L * corners);
    }
}
