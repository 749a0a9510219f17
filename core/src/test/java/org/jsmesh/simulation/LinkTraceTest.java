package org.jsmesh.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class LinkTraceTest {
    static Stream<LinkTrace> traces() {
        return LinkTrace.all().stream();
    }

    @ParameterizedTest
    @MethodSource("traces")
    void shouldVaryAboutItsMean(LinkTrace trace) {
        double sum = 0;
        int seeds = 30;
        for (int seed = 0; seed < seeds; seed++) {
            DoubleUnaryOperator rate = trace.course().bitsPerSecondAt(seed);
            for (int t = 0; t < 300_000; t += 100) {
                assertThat(rate.applyAsDouble(t)).isPositive();
                sum += rate.applyAsDouble(t);
            }
        }
        assertThat(sum / seeds / 3000).isCloseTo(trace.meanBitsPerSecond(), Percentage.withPercentage(15));
    }

    @ParameterizedTest
    @MethodSource("traces")
    void shouldBeTheSameForTheSameSeedAndAnotherForAnother(LinkTrace trace) {
        DoubleUnaryOperator one = trace.course().bitsPerSecondAt(1);
        DoubleUnaryOperator same = trace.course().bitsPerSecondAt(1);
        DoubleUnaryOperator other = trace.course().bitsPerSecondAt(2);
        boolean differs = false;
        for (int t = 0; t < 20_000; t += 50) {
            assertThat(same.applyAsDouble(t)).isEqualTo(one.applyAsDouble(t));
            differs |= other.applyAsDouble(t) != one.applyAsDouble(t);
        }
        assertThat(differs).isEqualTo(!trace.isConstant());
    }

    @Test
    void shouldFindTracesByName() {
        assertThat(LinkTrace.named("lte").meanBitsPerSecond()).isEqualTo(12e6);
        assertThat(LinkTrace.named("dsl")).isNull();
    }
}
