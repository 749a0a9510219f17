package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class CreaseAngleTest {
    @Test
    void shouldFallFromTheBaseToTheOriginal() {
        assertThat(degrees(100, 100, 10000)).isEqualTo(75, within(1e-9));
        assertThat(degrees(1000, 100, 10000)).isEqualTo(58.5, within(1e-9));
        assertThat(degrees(10000, 100, 10000)).isEqualTo(42, within(1e-9));
    }

    @Test
    void shouldBeThatOfTheOriginalWhenTheBaseIsAll() {
        assertThat(degrees(12, 12, 12)).isEqualTo(42, within(1e-9));
    }

    @Test
    void shouldBeginAtTheBaseWhileTheOriginalIsUnknown() {
        assertThat(degrees(100, 100, Integer.MAX_VALUE)).isEqualTo(75, within(1e-9));
        assertThat(degrees(0, 0, Integer.MAX_VALUE)).isBetween(42.0, 75.0);
    }

    private static double degrees(int faces, int base, int all) {
        return Math.toDegrees(Math.acos(CreaseAngle.cosine(faces, base, all)));
    }
}
