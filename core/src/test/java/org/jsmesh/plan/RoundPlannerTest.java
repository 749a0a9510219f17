package org.jsmesh.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.simulation.GeometricIndex;
import org.junit.jupiter.api.Test;

class RoundPlannerTest {
    private static final double WAIT_MILLIS = 2000;
    private static final BatchIndex LARGE = GeometricIndex.of(3000, 10_000_000);
    private final RoundPlanner planner = new RoundPlanner();

    @Test
    void shouldAskForAPrefixWhenNothingIsKnown() {
        planner.beginRound(0, WAIT_MILLIS);
        assertThat(planner.next(0, null, 0))
                .isEqualTo(new BatchRequest(0, RoundPlanner.FIRST_REQUEST_BYTES, 0, -1, 0, 0));
        assertThat(planner.bytesPerSecond(0)).isZero();
    }

    @Test
    void shouldAskForTheWholeBaseWhenTheManifestSaysItsSize() {
        planner.beginRound(0, WAIT_MILLIS);
        BatchRequest request = planner.next(0, GeometricIndex.of(40_000, 1_000_000), 0);
        assertThat(request.endByte()).isEqualTo(40_000);
        assertThat(request.endBatch()).isEqualTo(1);
    }

    @Test
    void shouldAskForWholeBatchesOfALittleMoreThanArrivesInTheWait() {
        learn(0, 100_000, 2000);
        planner.beginRound(3000, WAIT_MILLIS);
        BatchRequest request = planner.next(3000, LARGE, LARGE.end(60));
        assertThat(request.endByte()).isEqualTo(LARGE.end(request.endBatch() - 1));
        assertThat(request.bytes()).isBetween(210_000L, 240_000L);
        assertThat(BatchPlanner.plan(LARGE, request.fromBatch(), request.bytesPerSecond(), request.waitMillis()))
                .isEqualTo(request.endBatch());
    }

    @Test
    void shouldAskForMoreWhileTheEstimateIsALowerBound() {
        planner.sent(0);
        planner.arrived(40, 10_000);
        planner.arrived(50, 10_000);
        planner.ended(false);
        planner.beginRound(1000, WAIT_MILLIS);
        // 400 kB/s were seen, which says little of what two seconds bring.
        assertThat(planner.next(1000, LARGE, LARGE.end(60)).bytes()).isBetween(1_450_000L, 1_600_000L);
    }

    @Test
    void shouldNotAskForScrapsAtTheEndOfTheWait() {
        learn(0, 100_000, 2000);
        planner.beginRound(3000, WAIT_MILLIS);
        assertThat(planner.next(4800, LARGE, LARGE.end(60)).bytes()).isGreaterThan(40_000);
    }

    @Test
    void shouldAskForNothingWhenNothingCanArriveInTime() {
        learn(0, 100_000, 2000);
        planner.beginRound(3000, WAIT_MILLIS);
        assertThat(planner.next(3000, LARGE, LARGE.end(60))).isNotNull();
        assertThat(planner.next(4960, LARGE, LARGE.end(70))).isNull();
    }

    @Test
    void shouldAskOnceHoweverShortTheWait() {
        learn(0, 1000, 2000);
        planner.beginRound(3000, 1);
        assertThat(planner.next(3000, LARGE, LARGE.end(0))).isNotNull();
        assertThat(planner.next(3000, LARGE, LARGE.end(1))).isNull();
    }

    @Test
    void shouldGoOnAskingForTheBaseAfterTheDeadline() {
        learn(0, 1000, 2000);
        planner.beginRound(0, WAIT_MILLIS);
        assertThat(planner.isOver(5000, false)).isFalse();
        assertThat(planner.next(5000, LARGE, 1000).endByte()).isEqualTo(3000);
        assertThat(planner.isOver(5000, true)).isTrue();
        assertThat(planner.next(5000, LARGE, 3000)).isNull();
    }

    @Test
    void shouldAskForNothingAtTheEnd() {
        planner.beginRound(0, WAIT_MILLIS);
        assertThat(planner.next(0, LARGE, LARGE.archiveBytes())).isNull();
    }

    @Test
    void shouldBeOverAtTheDeadline() {
        planner.beginRound(100, WAIT_MILLIS);
        assertThat(planner.isOver(2099, true)).isFalse();
        assertThat(planner.isOver(2100, true)).isTrue();
    }

    @Test
    void shouldReadOnAfterTheRoundForAsLongAsTheWait() {
        planner.beginRound(0, WAIT_MILLIS);
        planner.sent(0);
        planner.arrived(500, 1000);
        assertThat(planner.mayGoOn(3999, 1_000_000)).isTrue();
        assertThat(planner.mayGoOn(4001, 1_000_000)).isFalse();
        assertThat(planner.mayGoOn(4001, 0)).isTrue();
    }

    @Test
    void shouldWaitForAResponseThatHasNotBegun() {
        planner.beginRound(0, WAIT_MILLIS);
        planner.sent(1900);
        assertThat(planner.mayGoOn(9000, 1_000_000)).isTrue();
        planner.arrived(9000, 100);
        assertThat(planner.mayGoOn(10_999, 1_000_000)).isTrue();
        assertThat(planner.mayGoOn(11_001, 1_000_000)).isFalse();
    }

    @Test
    void shouldNotLearnFromACache() {
        planner.sent(0);
        planner.arrived(1, 50_000);
        planner.ended(true);
        assertThat(planner.bytesPerSecond(1)).isZero();
    }

    @Test
    void shouldBearAClockThatStandsStill() {
        planner.sent(5);
        planner.arrived(4, 1000);
        planner.arrived(4, 0);
        planner.arrived(6, 1000);
        planner.ended(false);
        assertThat(planner.bytesPerSecond(6)).isPositive();
    }

    @Test
    void shouldShowTheRateOfAResponseUnderWay() {
        learn(0, 10_000, 2000);
        planner.sent(3000);
        for (int i = 1; i <= 10; i++) planner.arrived(3000 + 100 * i, 10_000);
        assertThat(planner.bytesPerSecond(4000)).isBetween(80_000.0, 120_000.0);
    }

    @Test
    void shouldRefuseAWaitOfNothing() {
        assertThatThrownBy(() -> planner.beginRound(0, 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("wait in milliseconds: 0");
    }

    /** A response with a portion every 100 ms. */
    private void learn(double startMillis, int bytesPerSecond, int millis) {
        planner.sent(startMillis);
        for (int i = 1; i * 100 <= millis; i++) planner.arrived(startMillis + i * 100, bytesPerSecond / 10);
        planner.ended(false);
    }
}
