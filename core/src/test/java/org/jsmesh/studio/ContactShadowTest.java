package org.jsmesh.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class ContactShadowTest {
    /** A triangle that stands, and one that lies. */
    private static final float[] POSITIONS = {
        -1, -.5f, -.5f, 1, -.5f, -.5f, 1, .5f, -.5f, -1, -.4f, .5f, 0, -.5f, .5f, 0, -.3f, 0
    };

    /** The numbers are those of {@code contact-shadow.js}. */
    @Test
    void shouldBeThatOfThePage() {
        ContactShadow shadow = ContactShadow.of(POSITIONS, new int[] {0, 1, 2, 3, 4, 5}, 1, .5, .5);
        assertThat(shadow.half()).isCloseTo(1.6, within(1e-12));
        assertThat(shadow.height()).isEqualTo(-.5);
        int[][] expected = {
            {48, 33, 36}, {20, 33, 22}, {75, 33, 21}, {40, 55, 109}, {30, 60, 95}, {48, 62, 71}, {0, 0, 0}
        };
        byte[] cells = shadow.cells();
        for (int[] cell : expected)
            assertThat(cells[cell[1] * ContactShadow.SIDE + cell[0]] & 255)
                    .as(cell[0] + ", " + cell[1])
                    .isEqualTo(cell[2]);
        long all = 0;
        for (byte cell : cells) all += cell & 255;
        assertThat((double) all).isCloseTo(62287, within(300.));
    }

    @Test
    void shouldBeAsDarkBetweenCellsAsTheyAreInTheMean() {
        ContactShadow shadow = ContactShadow.of(POSITIONS, new int[] {0, 1, 2, 3, 4, 5}, 1, .5, .5);
        double side = 3.2 / ContactShadow.SIDE;
        double x = (40.5 - 48) * side;
        double z = (55.5 - 48) * side;
        assertThat(shadow.at(x, z)).isCloseTo(.75 * 109 / 255, within(1e-9));
        assertThat(shadow.at(x + side / 2, z)).isCloseTo((shadow.at(x, z) + shadow.at(x + side, z)) / 2, within(1e-9));
        assertThat(shadow.at(1.61, 0)).isZero();
        assertThat(shadow.at(0, -1.61)).isZero();
    }

    @Test
    void shouldExistForAPointAndForNothing() {
        for (int[] indices : new int[][] {{}, {0, 0, 0}}) {
            ContactShadow shadow = ContactShadow.of(new float[3], indices, 0, 0, 0);
            assertThat(shadow.half()).isPositive();
            assertThat(shadow.at(0, 0)).isBetween(0., 1.);
        }
    }
}
