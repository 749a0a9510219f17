package org.jsmesh.app.heap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

class HeapPlanTest {
    private static final long GIGABYTE = 1L << 30;

    private final HeapPlan quarter = new HeapPlan(2 * GIGABYTE, 8 * GIGABYTE, false);

    @Test
    void shouldGoOnWithWhatIsEnough() {
        assertThat(quarter.forWork(17 * GIGABYTE / 10, GIGABYTE)).isZero();
    }

    @Test
    void shouldTakeMoreWhereItIsNeeded() {
        assertThat(quarter.forWork(3 * GIGABYTE, 2 * GIGABYTE)).isBetween(4 * GIGABYTE, 4 * GIGABYTE + (64 << 20));
    }

    @Test
    void shouldLeaveAFifthOfTheMachine() {
        assertThat(quarter.forWork(20 * GIGABYTE, GIGABYTE)).isEqualTo(64 * GIGABYTE / 10);
    }

    @Test
    void shouldNotStartAgainInVain() {
        assertThat(quarter.forWork(20 * GIGABYTE, 7 * GIGABYTE))
                .as("it cannot be done on this machine")
                .isZero();
        HeapPlan nearlyAll = new HeapPlan(6 * GIGABYTE, 8 * GIGABYTE, false);
        assertThat(nearlyAll.forWork(7 * GIGABYTE, GIGABYTE))
                .as("little is left")
                .isZero();
    }

    @Test
    void shouldLeaveTheHeapThatTheUserChose() {
        HeapPlan chosen = new HeapPlan(2 * GIGABYTE, 8 * GIGABYTE, true);
        assertThat(chosen.forWork(3 * GIGABYTE, GIGABYTE)).isZero();
        assertThat(HeapPlan.isHeapSet(List.of("-Dx=y", "-Xmx3g"))).isTrue();
        assertThat(HeapPlan.isHeapSet(List.of("-XX:MaxRAMPercentage=60"))).isTrue();
        assertThat(HeapPlan.isHeapSet(List.of("-XX:MaxRAM=2g", "-Xms1g", "-XX:+UseSerialGC")))
                .isFalse();
    }

    @Test
    void shouldTakeWhatTheUserWants() {
        assertThat(quarter.forUser(HeapSize.parse("3g"))).isEqualTo(3 * GIGABYTE);
        assertThat(quarter.forUser(HeapSize.parse("500m"))).isEqualTo(500L << 20);
        assertThat(quarter.forUser(HeapSize.parse("2048m"))).isZero();
    }

    @Test
    void shouldReadSizesAsJavaDoes() {
        assertThat(HeapSize.parse("6g").bytes()).isEqualTo(6 * GIGABYTE);
        assertThat(HeapSize.parse("1500M").option()).isEqualTo("-Xmx1500m");
        assertThat(HeapSize.parse("65536k").bytes()).isEqualTo(64 << 20);
        assertThat(HeapSize.parse("2147483648").bytes()).isEqualTo(2 * GIGABYTE);
        for (String wrong : List.of("", "g", "6 g", "-1g", "1.5g", "6gb", "1m", "999999999999t"))
            assertThatThrownBy(() -> HeapSize.parse(wrong)).hasMessageContaining("'" + wrong + "'");
    }
}
