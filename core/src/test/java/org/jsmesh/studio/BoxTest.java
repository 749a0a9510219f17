package org.jsmesh.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class BoxTest {
    private static final double ROOT = Math.sqrt(.5);

    @Test
    void shouldMeetTheNearSideFirstAndTheFarSideLast() {
        Box box = new Box(new double[] {5, 0, 0}, new double[] {1, 2, 3}, 0, 1);
        double[] right = {1, 0, 0};
        assertThat(box.enter(right)).isEqualTo(4);
        assertThat(box.leave(right)).isEqualTo(6);
        assertThat(box.normal(right, 4)).containsExactly(new double[] {-1, 0, 0}, within(1e-12));
        assertThat(box.enter(new double[] {-1, 0, 0})).isInfinite();
        assertThat(box.enter(new double[] {0, 1, 0})).isInfinite();
    }

    @Test
    void shouldMeetAnEdgeOfABoxThatIsTurnedByAnEighth() {
        Box box = new Box(new double[] {5, 0, 0}, new double[] {1, 1, 1}, ROOT, ROOT);
        double[] right = {1, 0, 0};
        assertThat(box.enter(right)).isCloseTo(5 - Math.sqrt(2), within(1e-12));
        // Below the middle line the ray meets the side that faces left and down.
        double[] aside = {Math.sqrt(1 - .01), 0, .1};
        double distance = box.enter(aside);
        assertThat(box.normal(aside, distance)).containsExactly(new double[] {-ROOT, 0, ROOT}, within(1e-12));
    }

    @Test
    void shouldBeLeftFromInside() {
        Box box = new Box(new double[] {0, 1, 0}, new double[] {9, 3, 9}, 0, 1);
        double[] up = {0, 1, 0};
        assertThat(box.enter(up)).isInfinite();
        assertThat(box.leave(up)).isEqualTo(4);
        assertThat(box.normal(up, 4)).containsExactly(new double[] {0, -1, 0}, within(1e-12));
    }
}
