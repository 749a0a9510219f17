package org.jsmesh.codec.attribute;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.jsmesh.mesh.TooLargeException;
import org.junit.jupiter.api.Test;

class NormalSumsTest {
    @Test
    void shouldKnowTheArcTangent() {
        Random random = new Random(1);
        for (int i = 0; i < 10_000; i++) {
            double y = random.nextDouble();
            double x = random.nextDouble() * (i % 3 == 0 ? 1e-9 : i % 3 == 1 ? 1 : 1e9);
            assertThat(NormalSums.arcTangent(y, x)).isCloseTo(Math.atan2(y, x), within(1e-15));
        }
        assertThat(NormalSums.arcTangent(1, 0)).isEqualTo(Math.PI / 2);
        assertThat(NormalSums.arcTangent(0, 1)).isZero();
    }

    @Test
    void shouldRefuseMoreThanAnArrayHolds() {
        assertThatThrownBy(() -> new NormalSums(NormalFormula.AREA, 600_000_000))
                .isInstanceOf(TooLargeException.class);
        assertThatThrownBy(() -> new NormalSums(NormalFormula.AREA, 1 << 30)).isInstanceOf(TooLargeException.class);
    }
}
