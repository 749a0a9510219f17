package org.jsmesh.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class RoomTest {
    private static double radiance(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return Room.radiance(new double[] {x / length, y / length, z / length});
    }

    @Test
    void shouldShowPanelsWhereTheyAre() {
        assertThat(radiance(-16, 14.37, 8.208)).isEqualTo(50);
        assertThat(radiance(-16, 18.021, -8.207)).isEqualTo(50);
        assertThat(radiance(14.904, 12.198, -1.832)).isEqualTo(17);
        assertThat(radiance(-.462, 8.89, 14.5)).isEqualTo(43);
        assertThat(radiance(3.235, 11.486, -12.5)).isEqualTo(20);
        assertThat(radiance(0, 1, 0)).isEqualTo(100);
    }

    /** The floor .933 below, 17.1 from the lamp that shines straight down on it. */
    @Test
    void shouldLightTheFloorByTheLamp() {
        double height = 16.199 + .9335;
        double faded = 1 - Math.pow(height / 28, 4);
        double matte = 900 / (height * height) * faded * faded / Math.PI;
        // A little gloss comes on top: light falls and is seen at small angles.
        assertThat(radiance(.418, -.9335, .3))
                .isCloseTo(matte, within(.03 * matte))
                .isGreaterThan(matte);
    }

    @Test
    void shouldLeaveSidesDarkThatTurnAwayFromTheLamp() {
        // The ceiling is above the lamp, but faces down to it; the lower side of a panel has its own light.
        assertThat(radiance(5, 27, 5)).isPositive();
        // The tall box to the left ends at 5.96 and begins with its right side, which the lamp lights.
        assertThat(radiance(-9.5, 2, 1.8)).isBetween(.05, 1.0);
        assertThat(radiance(-9.5, 2, 1.8)).isNotEqualTo(radiance(-9.5, 8, 1.8));
    }

    /** Some boxes reach through the floor: a ray that would meet them below it ends on the lit floor. */
    @Test
    void shouldShowTheFloorInFrontOfWhatIsBelowIt() {
        assertThat(radiance(.556, -.424, -.715)).isCloseTo(.71, within(.05));
        assertThat(radiance(-.591, -.308, -.745)).isCloseTo(.67, within(.05));
    }
}
