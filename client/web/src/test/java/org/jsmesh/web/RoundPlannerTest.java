package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;
import org.junit.jupiter.api.Test;

class RoundPlannerTest {
    private final RoundPlanner planner = new RoundPlanner();

    @Test
    void shouldAskForAPrefixWhileNothingIsKnown() {
        planner.beginRound(0, 2000);
        assertThat(planner.nextRequest(0, null, 0)).startsWith("0 16384 0 -1 ");
        assertThat(planner.bytesPerSecond()).isZero();
    }

    @Test
    void shouldAskForWholeBatchesAtTheThroughputSeen() {
        receive(0, 100_000);
        planner.beginRound(2000, 2000);
        String[] request = planner.nextRequest(2000, thousandBatches(), 100_000).split(" ");
        assertThat(request[0]).isEqualTo("100000");
        assertThat(Long.parseLong(request[1]) % 1000).isZero();
        assertThat(Long.parseLong(request[1])).isBetween(150_000L, 400_000L);
    }

    @Test
    void shouldNotLearnFromACache() {
        planner.beginResponse(0);
        planner.arrived(1, 50_000);
        planner.endResponse(true);
        assertThat(planner.bytesPerSecond()).isZero();
    }

    @Test
    void shouldBearAClockThatStandsStill() {
        planner.beginResponse(5);
        planner.arrived(4, 1000);
        planner.arrived(4, 0);
        planner.arrived(6, 1000);
        planner.endResponse(false);
        assertThat(planner.bytesPerSecond()).isPositive();
    }

    /** 100 kB in 1 s. */
    private void receive(double start, int bytes) {
        planner.beginResponse(start);
        for (int i = 0; i < 20; i++) planner.arrived(start + 50 * (i + 1), bytes / 20);
        planner.endResponse(false);
    }

    private static BatchIndex thousandBatches() {
        BatchIndexBuilder index = new BatchIndexBuilder();
        for (int i = 0; i < 1000; i++) index.add(i == 0 ? BatchKind.BASE : BatchKind.SPLITS, 1000, 10);
        return index.build();
    }
}
