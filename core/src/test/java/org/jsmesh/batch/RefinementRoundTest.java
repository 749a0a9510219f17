package org.jsmesh.batch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.throughput.ResponseSamples;
import org.jsmesh.throughput.ThroughputEstimator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class RefinementRoundTest {
    private static final double WAIT_MILLIS = 2000;
    private static final BatchIndex LARGE = Indexes.geometric(3000, 400_000_000L);

    /** Link, least mean detail in the first round, least mean and least p10 of the detail after it; details as share of what a client that knows the future gets. */
    static Stream<Arguments> links() {
        return Stream.of(
                link("64 kbit/s", i -> VirtualLink.constant(64e3), .95, .97, .95),
                link("256 kbit/s", i -> VirtualLink.constant(256e3), .90, .97, .95),
                link("1 Mbit/s", i -> VirtualLink.constant(1e6), .90, .97, .97),
                link("10 Mbit/s", i -> VirtualLink.constant(10e6), .85, .97, .97),
                link("100 Mbit/s", i -> VirtualLink.constant(100e6), .80, .97, .97),
                link("steps 10 and 1 Mbit/s", i -> VirtualLink.steps(10e6, 1e6, 3000, i * 300), .75, .90, .80),
                link("steps 1 and 20 Mbit/s", i -> VirtualLink.steps(1e6, 20e6, 3000, i * 300), .75, .88, .75),
                link("lognormal", i -> VirtualLink.lognormal(4e6, i), .80, .93, .78));
    }

    private static Arguments link(
            String name, IntFunction<DoubleUnaryOperator> rates, double first, double mean, double p10) {
        return Arguments.of(name, rates, first, mean, p10);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("links")
    void shouldShowMostOfWhatIsPossibleAtTheDeadline(
            String name, IntFunction<DoubleUnaryOperator> rates, double leastFirst, double leastMean, double leastP10) {
        List<VirtualSession.Seen> first = new ArrayList<>();
        List<VirtualSession.Seen> later = new ArrayList<>();
        long wasted = 0;
        long bytes = 0;
        for (int i = 0; i < 20; i++) {
            VirtualLink link = new VirtualLink(rates.apply(i), 40);
            VirtualSession session = new VirtualSession(LARGE, link);
            for (int round = 0; round < 6; round++) {
                (round == 0 ? first : later).add(session.refine(WAIT_MILLIS));
                link.now += 300;
            }
            wasted += link.wastedBytes;
            bytes += session.received();
        }
        List<VirtualSession.Seen> all = new ArrayList<>(first);
        all.addAll(later);
        double[] waits = all.stream()
                .mapToDouble(VirtualSession.Seen::waitShare)
                .sorted()
                .toArray();
        double[] details = later.stream()
                .mapToDouble(VirtualSession.Seen::detailShare)
                .sorted()
                .toArray();

        assertThat(waits[waits.length * 95 / 100]).as("wait / T, p95").isLessThanOrEqualTo(1.02);
        assertThat(waits[waits.length / 2]).as("wait / T, median").isGreaterThanOrEqualTo(.97);
        assertThat(first.stream()
                        .mapToDouble(VirtualSession.Seen::detailShare)
                        .average()
                        .orElseThrow())
                .as("first")
                .isGreaterThanOrEqualTo(leastFirst);
        assertThat(Arrays.stream(details).average().orElseThrow()).as("mean").isGreaterThanOrEqualTo(leastMean);
        assertThat(details[details.length / 10]).as("p10").isGreaterThanOrEqualTo(leastP10);
        assertThat(all.stream()
                        .mapToInt(VirtualSession.Seen::requests)
                        .average()
                        .orElseThrow())
                .as("requests")
                .isLessThanOrEqualTo(4);
        assertThat((double) wasted / bytes).as("wasted").isLessThanOrEqualTo(.06);
    }

    @Test
    void shouldNeverAskForAByteTwice() {
        VirtualSession session = new VirtualSession(LARGE, new VirtualLink(VirtualLink.lognormal(4e6, 7), 60));
        for (int round = 0; round < 8; round++) session.refine(WAIT_MILLIS);
        List<BatchRequest> requests = session.requests();
        assertThat(requests.get(0).fromByte()).isZero();
        for (int i = 1; i < requests.size(); i++) {
            assertThat(requests.get(i).fromByte())
                    .isGreaterThan(requests.get(i - 1).fromByte());
            assertThat(requests.get(i).fromByte())
                    .isLessThanOrEqualTo(requests.get(i - 1).endByte());
        }
    }

    @Test
    void shouldAskForWhatTheServerWouldSendAtTheSameEstimate() {
        VirtualSession session = new VirtualSession(LARGE, new VirtualLink(VirtualLink.steps(4e6, 1e6, 5000, 0), 30));
        for (int round = 0; round < 8; round++) session.refine(WAIT_MILLIS);
        int compared = 0;
        for (BatchRequest request : session.requests()) {
            if (request.endBatch() < 0 || request.fromByte() != LARGE.offset(request.fromBatch())) continue;
            assertThat(BatchPlanner.plan(LARGE, request.fromBatch(), request.bytesPerSecond(), request.waitMillis()))
                    .isEqualTo(request.endBatch());
            compared++;
        }
        assertThat(compared).isGreaterThan(5);
    }

    @Test
    void shouldAskForTheWholeBaseWhenTheManifestSaysItsSize() {
        BatchIndex index = Indexes.geometric(40_000, 1_000_000);
        BatchRequest request = new RefinementRound(new ThroughputEstimator(), 0, WAIT_MILLIS).next(0, index, 0);
        assertThat(request.endByte()).isEqualTo(40_000);
        assertThat(request.endBatch()).isEqualTo(1);
    }

    @Test
    void shouldAskForAPrefixWhenNothingIsKnown() {
        BatchRequest request = new RefinementRound(new ThroughputEstimator(), 0, WAIT_MILLIS).next(0, null, 0);
        assertThat(request).isEqualTo(new BatchRequest(0, RefinementRound.FIRST_BYTES, 0, -1, 0, 0));
    }

    @Test
    void shouldGoOnAskingForTheBaseAfterTheDeadline() {
        ThroughputEstimator slow = learned(1000, 1000);
        RefinementRound round = new RefinementRound(slow, 0, WAIT_MILLIS);
        assertThat(round.next(5000, Indexes.geometric(3000, 10_000), 1000).endByte())
                .isEqualTo(3000);
        assertThat(round.next(5000, Indexes.geometric(3000, 10_000), 3000)).isNull();
    }

    @Test
    void shouldAskForNothingAtTheEnd() {
        BatchIndex index = Indexes.geometric(3000, 10_000);
        assertThat(new RefinementRound(learned(1000, 1e6), 0, WAIT_MILLIS).next(0, index, index.archiveBytes()))
                .isNull();
    }

    @Test
    void shouldDrainOnlyWhatArrivesWithinTheGrace() {
        RefinementRound round = new RefinementRound(learned(1000, 1000), 0, WAIT_MILLIS);
        ResponseSamples response = new ResponseSamples(0);
        response.arrived(2000, 20_000); // 10 kB/s
        assertThat(round.mayDrain(2000, 5000, response, false)).isTrue();
        assertThat(round.mayDrain(2000, 5100, response, false)).isFalse();
        assertThat(round.mayDrain(2000, 10_000, response, true)).isTrue();
    }

    @Test
    void shouldWaitForAResponseThatHasNotBegun() {
        RefinementRound round = new RefinementRound(learned(1000, 1000), 0, WAIT_MILLIS);
        assertThat(round.mayDrain(WAIT_MILLIS, 1 << 30, new ResponseSamples(0), false))
                .isTrue();
    }

    @Test
    void shouldAskOnceHoweverShortTheWait() {
        BatchIndex index = Indexes.geometric(3000, 10_000);
        RefinementRound round = new RefinementRound(learned(1000, 1000), 0, 1);
        assertThat(round.next(0, index, index.end(0))).isNotNull();
        assertThat(round.next(0, index, index.end(1))).isNull();
    }

    /** An estimator that saw one response of two seconds. */
    private static ThroughputEstimator learned(double startMillis, double bytesPerSecond) {
        ThroughputEstimator estimator = new ThroughputEstimator();
        ResponseSamples response = new ResponseSamples(startMillis);
        for (int i = 1; i <= 20; i++) response.arrived(startMillis + i * 100, (int) (bytesPerSecond / 10));
        estimator.learn(response);
        return estimator;
    }
}
