package org.jsmesh.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import org.jsmesh.archive.BatchIndex;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class SimulatedVisitorTest {
    private static final BatchIndex INDEX = GeometricIndex.of(3000, 2_000_000);

    @ParameterizedTest
    @EnumSource(HttpVersion.class)
    void shouldComeToTheEndWithoutAByteTooMany(HttpVersion version) {
        SimulatedVisitor visitor = SimulatedVisitor.of(INDEX, LinkTrace.named("steps-10-1"), 3, version, 40);
        long before = 0;
        for (int i = 0; i < 50 && visitor.received() < INDEX.archiveBytes(); i++) {
            SimulatedVisitor.Round round = visitor.refine(500);
            assertThat(round.beforeBytes()).isEqualTo(before);
            assertThat(round.bytes()).isGreaterThanOrEqualTo(before);
            before = round.bytes();
        }
        assertThat(visitor.received()).isEqualTo(INDEX.archiveBytes());
        // Whoever asks on at once gives nothing up.
        assertThat(visitor.wastedBytes()).isZero();
    }

    @Test
    void shouldGoOnWithWhatTheDeadlineOvertookAndGiveItUpWhenNobodyAsks() {
        LinkTrace trace = new LinkTrace("falling", 1e6, false, seed -> t -> t < 3000 ? 4e6 : 100e3);
        SimulatedVisitor patient = SimulatedVisitor.of(INDEX, trace, 0, HttpVersion.HTTP_2, 40);
        patient.refine(2000);
        patient.refine(2000);
        SimulatedVisitor.Round handedOver = patient.refine(2000);
        assertThat(handedOver.requests()).isZero();
        assertThat(handedOver.bytes()).isGreaterThan(handedOver.beforeBytes() + 20_000);
        patient.rest(10_000);
        assertThat(patient.wastedBytes()).isPositive();
        assertThat(patient.refine(2000).requests()).isPositive();
    }
}
