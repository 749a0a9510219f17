package org.jsmesh.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.simulation.GeometricIndex;
import org.junit.jupiter.api.Test;

class BatchPlannerTest {
    /** 3000 | 1024 | 1024 | … */
    private final BatchIndex index = GeometricIndex.of(3000, 20_000);

    @Test
    void shouldFitWholeBatchesIntoRateTimesWait() {
        assertThat(BatchPlanner.plan(index, 1, 1024, 2000)).isEqualTo(3);
        assertThat(BatchPlanner.plan(index, 1, 1024, 1999)).isEqualTo(2);
        assertThat(BatchPlanner.plan(index, 1, 1023, 2000)).isEqualTo(2);
    }

    @Test
    void shouldPlanAtLeastOneBatch() {
        assertThat(BatchPlanner.plan(index, 0, 0, 2000)).isEqualTo(1);
        assertThat(BatchPlanner.plan(index, 4, 1, 1)).isEqualTo(5);
        assertThat(BatchPlanner.planFromByte(index, 3500, 1, 1)).isEqualTo(2);
    }

    @Test
    void shouldStopAtTheEnd() {
        assertThat(BatchPlanner.plan(index, 0, 1e12, 1e9)).isEqualTo(index.size());
        assertThat(BatchPlanner.plan(index, index.size() - 1, 0, 0)).isEqualTo(index.size());
        assertThat(BatchPlanner.plan(index, index.size(), 1e6, 2000)).isEqualTo(index.size());
    }

    @Test
    void shouldPlanMoreForMoreBandwidth() {
        int last = 0;
        for (double rate = 100; rate < 20_000; rate *= 1.5) {
            int end = BatchPlanner.plan(index, 1, rate, 2000);
            assertThat(end).isGreaterThanOrEqualTo(last);
            last = end;
        }
        assertThat(last).isGreaterThan(10);
    }

    @Test
    void shouldRefuseArgumentsThatMeanNothing() {
        assertThatThrownBy(() -> BatchPlanner.plan(index, -1, 1, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("-1");
        assertThatThrownBy(() -> BatchPlanner.plan(index, 99, 1, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("99");
        assertThatThrownBy(() -> BatchPlanner.plan(index, 1, Double.NaN, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("NaN");
        assertThatThrownBy(() -> BatchPlanner.plan(index, 1, 1, -2))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("-2");
    }
}
