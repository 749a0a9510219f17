package org.jsmesh.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class StudioTest {
    private static final float[] LIGHT = Studio.light();

    /**
     * What three.js 0.181 has in some directions after all its steps of blur, as read back from the texture of
     * {@code PMREMGenerator.fromScene(new RoomEnvironment(), .04, .1, 100, { size: 128 })}: to right, left, up, front
     * and back.
     */
    @Test
    void shouldLightMatteSurfacesAsThreeDoes() {
        double[][] directions = {{1, .1, .2}, {-1, .3, .1}, {.1, 1, .2}, {.2, -1, .1}, {.1, .2, 1}, {.2, .1, -1}};
        double[] expected = {.883, .832, 1.889, .710, 2.073, .623};
        for (int i = 0; i < directions.length; i++) {
            assertThat(at(Studio.LEVELS - 1, directions[i])).isCloseTo(expected[i], within(.02 * expected[i]));
        }
    }

    @Test
    void shouldShowSharpThingsAsThreeDoes() {
        double[][] directions = {{1, .1, .2}, {-1, .3, .1}, {.2, -1, .1}, {1, .8, -.1}, {0, .6, 1}, {.7, .7, .7}};
        double[] expected = {.218, .461, .729, 16.491, 43.0, .28};
        for (int i = 0; i < directions.length; i++) {
            assertThat(at(0, directions[i])).isCloseTo(expected[i], within(.02 * expected[i]));
        }
    }

    /** Blur moves light and makes none: rough surfaces get as much as smooth ones. */
    @Test
    void shouldKeepTheLightOfAllDirections() {
        double sharp = mean(0);
        for (int level = 1; level < Studio.LEVELS; level++)
            assertThat(mean(level)).isCloseTo(sharp, within(.1 * sharp));
        assertThat(brightest(0)).isGreaterThan(10 * brightest(Studio.LEVELS - 1));
    }

    private static double at(int level, double[] d) {
        double sum = Math.abs(d[0]) + Math.abs(d[1]) + Math.abs(d[2]);
        double x = d[0] / sum;
        double z = d[2] / sum;
        if (d[1] < 0) {
            double folded = (1 - Math.abs(z)) * Math.signum(x);
            z = (1 - Math.abs(x)) * Math.signum(z);
            x = folded;
        }
        int inner = Studio.SIDE - 2;
        int column = 1 + (int) ((x + 1) / 2 * inner);
        int row = 1 + (int) ((z + 1) / 2 * inner);
        return LIGHT[(level * Studio.SIDE + row) * Studio.SIDE + column];
    }

    /** Over directions that are spread evenly. */
    private static double mean(int level) {
        int count = 20_000;
        double sum = 0;
        for (int i = 0; i < count; i++) {
            double y = 2 * (i + .5) / count - 1;
            double wide = Math.sqrt(1 - y * y);
            double around = i * Math.PI * (3 - Math.sqrt(5));
            sum += at(level, new double[] {wide * Math.cos(around), y, wide * Math.sin(around)});
        }
        return sum / count;
    }

    private static double brightest(int level) {
        double most = 0;
        for (int i = 0; i < Studio.SIDE * Studio.SIDE; i++)
            most = Math.max(most, LIGHT[level * Studio.SIDE * Studio.SIDE + i]);
        return most;
    }
}
