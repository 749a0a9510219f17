package org.jsmesh.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class CubePictureTest {
    private static final int SIZE = 32;

    private static double slope(double[] d) {
        return 3 * d[0] + 2 * d[1] - d[2];
    }

    @Test
    void shouldGiveAFunctionInEveryDirection() {
        CubePicture picture = CubePicture.of(SIZE, CubePictureTest::slope);
        Random random = new Random(1);
        for (int i = 0; i < 1000; i++) {
            double[] d = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
            double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
            assertThat(picture.at(d)).isCloseTo(slope(d) / length, within(.01));
        }
    }

    /** The corners are read too. */
    @Test
    void shouldReadTheEdgesOfASide() {
        CubePicture picture = CubePicture.of(SIZE, CubePictureTest::slope);
        for (double[] d : new double[][] {{1, 1, 1}, {-1, 1, -1}, {-1, -1, -1}, {0, 1, 1}, {0, -1, 0}})
            assertThat(picture.at(d)).isCloseTo(slope(d) / Math.sqrt(lengthSquared(d)), within(.01));
    }

    private static double lengthSquared(double[] d) {
        return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    }

    /** As on a graphics card: the middle of a pixel decides, and the pixels without those at the edge fill the side. */
    @Test
    void shouldDrawASceneALittleTooLarge() {
        CubePicture picture = CubePicture.drawn(SIZE, d -> d[0] > 0 && Math.abs(d[1] / d[0]) < .5 ? 1 : 0);
        double edge = .5 * SIZE / (SIZE - 2);
        assertThat(picture.at(1, edge - .05, 0)).isEqualTo(1);
        assertThat(picture.at(1, edge + .05, 0)).isEqualTo(0);
        assertThat(picture.at(-1, 0, 0)).isEqualTo(0);
    }
}
