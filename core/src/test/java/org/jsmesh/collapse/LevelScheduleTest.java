package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class LevelScheduleTest {
    private final LevelSchedule levels = new LevelSchedule(3);

    @Test
    void shouldBeginAtTheFirstCost() {
        assertThat(levels.threshold()).isEqualTo(3);
        assertThat(levels.level()).isZero();
    }

    @Test
    void shouldStayWhileTheCostBelongsToTheLevel() {
        levels.reach(3);
        assertThat(levels.level()).isZero();
    }

    @Test
    void shouldLeaveOutLevelsThatWouldBeEmpty() {
        levels.reach(50);
        assertThat(levels.level()).isEqualTo(1);
        assertThat(levels.threshold()).isEqualTo(192);
        levels.reach(200);
        assertThat(levels.thresholds()).containsExactly(3, 192, 768);
    }

    @Test
    void shouldGrowFromNoCostAtAll() {
        LevelSchedule flat = new LevelSchedule(0);
        flat.reach(1);
        assertThat(flat.threshold()).isGreaterThanOrEqualTo(1);
    }
}
