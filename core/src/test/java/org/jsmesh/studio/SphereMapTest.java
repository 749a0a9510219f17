package org.jsmesh.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class SphereMapTest {
    /** Of no class: other threads take the function, and would wait for a class that waits for them. */
    private final SphereMap linear = SphereMap.of(64, d -> 2 + d[0] + .5 * d[1] - .25 * d[2]);

    /** Over the edge of the map, too, which lies along half of the great circles through the axes. */
    @Test
    void shouldGiveTheFunctionBackInEveryDirection() {
        for (int i = 0; i < 1000; i++) {
            double y = 2 * (i + .5) / 1000 - 1;
            double wide = Math.sqrt(1 - y * y);
            double x = wide * Math.cos(2.4 * i);
            double z = wide * Math.sin(2.4 * i);
            assertThat(linear.at(3 * x, 3 * y, 3 * z)).isCloseTo(2 + x + .5 * y - .25 * z, within(.02));
        }
        assertThat(linear.at(0, -1, 0)).isCloseTo(1.5, within(.02));
    }

    @Test
    void shouldHaveTheNeighbourOverTheEdgeBeyondIt() {
        for (int i = 0; i < 64; i++) {
            assertThat(linear.pixel(-1, i)).isEqualTo(linear.pixel(0, 63 - i));
            assertThat(linear.pixel(64, i)).isEqualTo(linear.pixel(63, 63 - i));
            assertThat(linear.pixel(i, -1)).isEqualTo(linear.pixel(63 - i, 0));
            assertThat(linear.pixel(i, 64)).isEqualTo(linear.pixel(63 - i, 63));
        }
    }

    @Test
    void shouldTakeEachPlaceForOneDirection() {
        assertThat(SphereMap.direction(.5, .5)).containsExactly(new double[] {0, 1, 0}, within(1e-12));
        assertThat(SphereMap.direction(1, .5)).containsExactly(new double[] {1, 0, 0}, within(1e-12));
        assertThat(SphereMap.direction(.5, 0)).containsExactly(new double[] {0, 0, -1}, within(1e-12));
        assertThat(SphereMap.direction(0, 0)).containsExactly(new double[] {0, -1, 0}, within(1e-12));
    }
}
