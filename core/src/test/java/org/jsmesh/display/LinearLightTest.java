package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class LinearLightTest {
    @Test
    void shouldGiveTheLightOfScreenValues() {
        for (int i = 0; i <= 255; i++) {
            double s = i / 255.0;
            double light = s <= .04045 ? s / 12.92 : Math.pow((s + .055) / 1.055, 2.4);
            assertThat(LinearLight.light(s)).isCloseTo(light, within(1e-12));
            assertThat(LinearLight.level(light)).isEqualTo(i);
            assertThat(LinearLight.toScreen((float) light)).isCloseTo((float) s, within(1e-6f));
        }
        assertThat(LinearLight.level(-1)).isZero();
        assertThat(LinearLight.level(Double.NaN)).isZero();
        assertThat(LinearLight.level(9)).isEqualTo(255);
    }
}
