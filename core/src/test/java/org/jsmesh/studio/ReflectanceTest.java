package org.jsmesh.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class ReflectanceTest {
    private static final float[] TABLE = Reflectance.table();

    /** Scale and bias of three.js 0.181, from its table of the same size, computed with 4,096 samples. */
    @Test
    void shouldAgreeWithTheTableOfThree() {
        assertEntry(0, 0, .0757, .9238);
        assertEntry(0, 5, .6104, .3894);
        assertEntry(0, 16, .9731, .0267);
        assertEntry(9, 2, .5347, .3457);
        assertEntry(15, 8, .7622, .0811);
        assertEntry(31, 20, .4104, .0014);
    }

    /** A mirror reflects as Schlick's term says. */
    @Test
    void shouldReflectAllInASmoothMirror() {
        for (int row = 0; row < Reflectance.SIDE; row++) {
            double scale = TABLE[2 * row * Reflectance.SIDE];
            double bias = TABLE[2 * row * Reflectance.SIDE + 1];
            assertThat(scale + bias).isCloseTo(1, within(.002));
            assertThat(bias).isCloseTo(Math.pow(1 - (row + .5) / Reflectance.SIDE, 5), within(.002));
        }
    }

    private static void assertEntry(int column, int row, double scale, double bias) {
        int at = 2 * (row * Reflectance.SIDE + column);
        assertThat((double) TABLE[at]).isCloseTo(scale, within(.01));
        assertThat((double) TABLE[at + 1]).isCloseTo(bias, within(.01));
    }
}
