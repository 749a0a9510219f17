package org.jsmesh.codec.position;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class RunningFitTest {
    @Test
    void shouldPredictByItsFirstWeights() {
        assertThat(new RunningFit(1, -.5).predict(3, 4)).isEqualTo(1);
    }

    @Test
    void shouldFindTheWeightsBehindValues() {
        RunningFit fit = new RunningFit(0, 0);
        Random random = new Random(7);
        for (int i = 0; i < 4000; i++) {
            double x = random.nextGaussian() * 10;
            double y = random.nextGaussian() * 10;
            fit.learn(x, y, .7 * x - .2 * y + random.nextGaussian(), 1);
        }
        assertThat(fit.predict(1, 0)).isCloseTo(.7, within(.02));
        assertThat(fit.predict(0, 1)).isCloseTo(-.2, within(.02));
    }

    @Test
    void shouldHardlyHeedValuesFarOff() {
        RunningFit fit = new RunningFit(0, 0);
        Random random = new Random(8);
        for (int i = 0; i < 4000; i++) {
            double x = random.nextGaussian() * 10;
            double y = random.nextGaussian() * 10;
            fit.learn(x, y, i % 5 == 0 ? 1000 * x : x, .3);
        }
        assertThat(fit.predict(1, 0)).isCloseTo(1, within(.02));
    }

    @Test
    void shouldForgetOldValues() {
        RunningFit fit = new RunningFit(0, 0);
        Random random = new Random(9);
        for (int i = 0; i < 40_000; i++) {
            double x = random.nextGaussian() * 10;
            double y = random.nextGaussian() * 10;
            fit.learn(x, y, i < 20_000 ? x : y, 1);
        }
        assertThat(fit.predict(1, 0)).isCloseTo(0, within(.02));
        assertThat(fit.predict(0, 1)).isCloseTo(1, within(.02));
    }

    @Test
    void shouldKeepItsWeightsWhereNothingTellsThemApart() {
        RunningFit fit = new RunningFit(1, -.5);
        for (int i = 0; i < 100; i++) fit.learn(0, 0, 5, 1);
        assertThat(fit.predict(3, 4)).isCloseTo(1, within(1e-9));
    }
}
