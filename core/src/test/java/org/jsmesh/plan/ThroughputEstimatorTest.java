package org.jsmesh.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class ThroughputEstimatorTest {
    private final ThroughputEstimator estimator = new ThroughputEstimator();

    @Test
    void shouldKnowNothingBeforeTheFirstResponse() {
        assertThat(estimator.isKnown()).isFalse();
        assertThat(estimator.bytesPerSecond()).isZero();
        estimator.learn(new ResponseSamples(0));
        assertThat(estimator.isKnown()).isFalse();
        assertThat(estimator.isUnsaturated()).isTrue();
    }

    @Test
    void shouldMeasureASteadyResponseExactly() {
        estimator.learn(steady(0, 50, 100_000, 2000));
        assertThat(estimator.bytesPerSecond()).isCloseTo(100_000, within(1e-6));
        assertThat(estimator.timeToFirstByteMillis()).isEqualTo(50);
        assertThat(estimator.isUnsaturated()).isFalse();
    }

    @Test
    void shouldNotLetBufferedFirstBytesInflateTheRate() {
        ResponseSamples response = new ResponseSamples(0);
        response.arrived(50, 500_000);
        for (int i = 1; i <= 20; i++) response.arrived(50 + 100 * i, 10_000);
        estimator.learn(response);
        assertThat(estimator.bytesPerSecond()).isCloseTo(100_000, within(1e-6));
    }

    @Test
    void shouldTakeAShortResponseAsALowerBound() {
        ResponseSamples response = new ResponseSamples(1000);
        response.arrived(1090, 4000);
        response.arrived(1100, 1000);
        estimator.learn(response);
        assertThat(estimator.bytesPerSecond()).isCloseTo(50_000, within(1e-6));
        assertThat(estimator.isUnsaturated()).isTrue();
    }

    @Test
    void shouldTakeOneWindowShorterThanFourLatenciesAsALowerBound() {
        estimator.learn(steady(0, 60, 100_000, 190));
        assertThat(estimator.isUnsaturated()).isTrue();
    }

    @Test
    void shouldDropTheSlowStart() {
        ResponseSamples response = new ResponseSamples(0);
        response.arrived(50, 1000);
        int[] perWindow = {10_000, 20_000, 40_000, 80_000, 80_000, 80_000};
        for (int i = 0; i < perWindow.length; i++) response.arrived(150 + 100 * i, perWindow[i]);
        estimator.learn(response);
        assertThat(estimator.bytesPerSecond()).isCloseTo(800_000, within(1e-6));
        assertThat(estimator.isUnsaturated()).isFalse();
    }

    @Test
    void shouldCallAResponseThatStillGrowsUnsaturated() {
        ResponseSamples response = new ResponseSamples(0);
        response.arrived(50, 1000);
        response.arrived(150, 10_000);
        response.arrived(250, 20_000);
        estimator.learn(response);
        assertThat(estimator.isUnsaturated()).isTrue();
    }

    @Test
    void shouldRiseAtOnceAndFallSlowly() {
        estimator.learn(steady(0, 20, 1_000_000, 4000));
        estimator.learn(steady(5000, 20, 100_000, 2000));
        assertThat(estimator.bytesPerSecond()).isBetween(150_000.0, 350_000.0);
        ThroughputEstimator rising = new ThroughputEstimator();
        rising.learn(steady(0, 20, 100_000, 4000));
        rising.learn(steady(5000, 20, 1_000_000, 1000));
        assertThat(rising.bytesPerSecond()).isCloseTo(1_000_000, within(1.0));
    }

    @Test
    void shouldLearnNextToNothingFromTheRestOfABatch() {
        estimator.learn(steady(0, 50, 100_000, 2000));
        estimator.learn(steady(3000, 50, 10_000, 200));
        assertThat(estimator.bytesPerSecond()).isCloseTo(100_000, within(1e-6));
        assertThat(estimator.isUnsaturated()).isFalse();
    }

    @Test
    void shouldCapTheLatencyOfTheFirstResponseAndAverageLaterOnes() {
        estimator.learn(steady(0, 900, 100_000, 2000));
        assertThat(estimator.timeToFirstByteMillis()).isEqualTo(200);
        estimator.learn(steady(5000, 100, 100_000, 2000));
        assertThat(estimator.timeToFirstByteMillis()).isEqualTo(150);
    }

    @Test
    void shouldLearnTheSameFromArrays() {
        double[] at = new double[20];
        int[] bytes = new int[20];
        for (int i = 0; i < 20; i++) {
            at[i] = 50 + 37 * i;
            bytes[i] = 3000 + 100 * i;
        }
        ThroughputEstimator other = new ThroughputEstimator();
        ResponseSamples response = new ResponseSamples(10);
        for (int i = 0; i < 20; i++) response.arrived(at[i], bytes[i]);
        estimator.learn(10, at, bytes, 20);
        other.learn(response);
        assertThat(estimator.bytesPerSecond()).isPositive().isEqualTo(other.bytesPerSecond());
        assertThat(estimator.isUnsaturated()).isEqualTo(other.isUnsaturated());
    }

    @Test
    void shouldLookAheadWithoutLearning() {
        estimator.learn(steady(0, 20, 1_000_000, 4000));
        ResponseSamples underWay = steady(5000, 20, 100_000, 2000);
        double before = estimator.bytesPerSecond();
        double ahead = estimator.bytesPerSecondWith(underWay);
        assertThat(estimator.bytesPerSecond()).isEqualTo(before);
        estimator.learn(underWay);
        assertThat(estimator.bytesPerSecond()).isEqualTo(ahead).isLessThan(before);
    }

    @Test
    void shouldRefuseArrivalsOutOfOrder() {
        ResponseSamples response = new ResponseSamples(100);
        response.arrived(150, 1);
        assertThatThrownBy(() -> response.arrived(140, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("140");
        assertThatThrownBy(() -> response.arrived(160, 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("0 bytes");
    }

    @Test
    void shouldHalveLikeThePowerFunction() {
        for (double x = 0; x < 70; x += 0.0625)
            assertThat(MovingAverage.half(x)).isCloseTo(Math.pow(2, -x), within(1e-15));
    }

    /** Ten-millisecond portions at a steady rate after the first byte. */
    private static ResponseSamples steady(
            double startMillis, double latencyMillis, double bytesPerSecond, double millis) {
        ResponseSamples response = new ResponseSamples(startMillis);
        double first = startMillis + latencyMillis;
        response.arrived(first, 1000);
        for (int i = 1; i * 10 <= millis - latencyMillis; i++)
            response.arrived(first + 10 * i, (int) (bytesPerSecond / 100));
        return response;
    }
}
