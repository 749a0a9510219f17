package org.jsmesh.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.jsmesh.simulation.PlannerComparison.Planner.CHUNKS;
import static org.jsmesh.simulation.PlannerComparison.Planner.DASH;
import static org.jsmesh.simulation.PlannerComparison.Planner.JSM;
import static org.jsmesh.simulation.PlannerComparison.Planner.PAPER;

import java.util.stream.Stream;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.simulation.PlannerComparison.Result;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** What the planner promises, on every kind of link and with either version of HTTP, in virtual time. */
@Tag("slow")
class PlannerGoalsTest {
    private static final BatchIndex LARGE = GeometricIndex.of(3000, 400_000_000);

    static Stream<Arguments> links() {
        return LinkTrace.all().stream()
                .flatMap(trace -> Stream.of(HttpVersion.values()).map(version -> Arguments.of(trace, version)));
    }

    @ParameterizedTest(name = "{0} {1}")
    @MethodSource("links")
    void shouldKeepTheWaitAndBringTheDetail(LinkTrace trace, HttpVersion version) {
        Result r = PlannerComparison.run(LARGE, trace, version, JSM);
        boolean isSlow = trace.meanBitsPerSecond() < 1e6;
        boolean isStepping = trace.name().startsWith("steps");
        assertThat(r.waitP95()).as("wait / T, p95").isLessThanOrEqualTo(1.02);
        assertThat(r.waitMedian()).as("wait / T, median").isBetween(.97, 1.01);
        assertThat(r.first()).as("first round").isGreaterThanOrEqualTo(isStepping ? .75 : .80);
        assertThat(r.mean()).as("later rounds").isGreaterThanOrEqualTo(trace.isConstant() ? isSlow ? .93 : .97 : .93);
        assertThat(r.p10()).as("p10").isGreaterThanOrEqualTo(.78);
        assertThat(r.wasted()).as("wasted").isLessThanOrEqualTo(version == HttpVersion.HTTP_1_1 ? .06 : .10);
        assertThat(r.unseen()).as("unseen at the end").isLessThanOrEqualTo(.10);
        assertThat(r.requests()).as("requests").isLessThanOrEqualTo(4);
    }

    /** Rates that change, and all that is little to be had from: what a planner is for. */
    @Test
    void shouldBringMoreThanOtherPlannersWhereRatesChange() {
        for (String name : new String[] {"steps-10-1", "steps-1-20", "lognormal", "lte", "100M"}) {
            LinkTrace trace = LinkTrace.named(name);
            double mean = PlannerComparison.run(LARGE, trace, HttpVersion.HTTP_1_1, JSM)
                    .mean();
            for (PlannerComparison.Planner other : new PlannerComparison.Planner[] {CHUNKS, PAPER, DASH}) {
                assertThat(PlannerComparison.run(LARGE, trace, HttpVersion.HTTP_1_1, other)
                                .mean())
                        .as("%s on %s", other, name)
                        .isLessThan(mean - .04);
            }
        }
    }

    @Test
    void shouldShowWhatOthersCost() {
        Result chunks = PlannerComparison.run(LARGE, LinkTrace.named("64k"), HttpVersion.HTTP_1_1, CHUNKS);
        assertThat(chunks.waitMedian()).isGreaterThan(4);
        Result paper = PlannerComparison.run(LARGE, LinkTrace.named("lognormal"), HttpVersion.HTTP_1_1, PAPER);
        assertThat(paper.waitP95()).isGreaterThan(1.5);
        Result dash = PlannerComparison.run(LARGE, LinkTrace.named("steps-10-1"), HttpVersion.HTTP_1_1, DASH);
        assertThat(dash.waitP95()).isGreaterThan(1.5);
    }

    @Test
    void shouldComeToTheSameEveryTime() {
        LinkTrace lte = LinkTrace.named("lte");
        assertThat(PlannerComparison.run(LARGE, lte, HttpVersion.HTTP_2, JSM))
                .isEqualTo(PlannerComparison.run(LARGE, lte, HttpVersion.HTTP_2, JSM));
    }
}
