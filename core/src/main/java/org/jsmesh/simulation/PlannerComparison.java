package org.jsmesh.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Supplier;
import org.jsmesh.archive.BatchIndex;

/** Many visitors on links of one kind, with jSM's planner or another. Deterministic. */
public final class PlannerComparison {
    /** The wait T. */
    public static final double WAIT_MILLIS = 2000;

    private static final int VISITORS = 20;
    private static final int ROUNDS = 6;
    private static final double ROUND_TRIP_MILLIS = 40;
    private static final double SERVER_MILLIS = 5;
    private static final double LONGEST_REST_MILLIS = 3000;

    /** Who plans. */
    public enum Planner {
        /** Chunks of 64 kB until the wait is over. */
        CHUNKS("fixed 64 kB", () -> PatientClient.chunks(65_536)),
        /** Section 5.2 of Chen and Nishita 2002. */
        PAPER("paper's average", PatientClient::paper),
        /** The way of video players. */
        DASH("dash.js-like", PatientClient::dash),
        /** This project's. */
        JSM("jSM", PlannedClient::new);

        private final String label;
        private final Supplier<SimulatedClient> client;

        Planner(String label, Supplier<SimulatedClient> client) {
            this.label = label;
            this.client = client;
        }

        /** {@return the name for people, as tables show it} */
        public String label() {
            return label;
        }
    }

    /**
     * What the visitors saw. Shares are of 1. Details are bytes of whole batches, relative to those of a client that
     * knows the link's course, at most 1.
     *
     * @param trace name of the link's kind
     * @param version label of the version of HTTP
     * @param planner label of who planned
     * @param waitMedian wait ÷ T
     * @param waitP95 the same, of the 95th of 100 rounds
     * @param first mean detail of the first rounds
     * @param mean of the rounds after the first
     * @param p10 of these, the 10th of 100
     * @param wasted bytes that crossed the link for nobody ÷ bytes received
     * @param unseen bytes received but not shown when the last round ended ÷ bytes received
     * @param requests per round
     */
    public record Result(
            String trace,
            String version,
            String planner,
            double waitMedian,
            double waitP95,
            double first,
            double mean,
            double p10,
            double wasted,
            double unseen,
            double requests) {}

    private PlannerComparison() {}

    /**
     * 20 visitors with 6 rounds each, who look at what they got for up to 3 s or ask for more at once.
     *
     * @param index of the archive that all of them look at
     * @param trace kind of their links; each visitor has a course of his own
     * @param version of HTTP that client and server speak
     * @param planner decides what they ask for
     * @return figures of all visitors together, the same in every run
     */
    public static Result run(BatchIndex index, LinkTrace trace, HttpVersion version, Planner planner) {
        List<Double> waits = new ArrayList<>();
        List<Double> first = new ArrayList<>();
        List<Double> later = new ArrayList<>();
        double wasted = 0;
        double received = 0;
        double unseen = 0;
        double requests = 0;
        for (int i = 0; i < VISITORS; i++) {
            Random habits = new Random(1000 + i);
            DoubleUnaryOperator rate = trace.course().bitsPerSecondAt(i);
            SimulatedVisitor visitor = new SimulatedVisitor(
                    index,
                    () -> new VirtualLink(rate, trace.meanBitsPerSecond(), version, ROUND_TRIP_MILLIS, SERVER_MILLIS),
                    planner.client.get());
            long shown = 0;
            for (int round = 0; round < ROUNDS; round++) {
                SimulatedVisitor.Round r = visitor.refine(WAIT_MILLIS);
                waits.add(r.waitMillis() / WAIT_MILLIS);
                (round == 0 ? first : later).add(detail(index, r));
                requests += r.requests();
                shown = r.bytes();
                if (habits.nextInt(3) > 0) visitor.rest(habits.nextDouble() * LONGEST_REST_MILLIS);
            }
            visitor.rest(2 * WAIT_MILLIS);
            wasted += visitor.wastedBytes();
            received += visitor.received();
            unseen += visitor.received() - shown;
        }
        return new Result(
                trace.name(),
                version.label(),
                planner.label(),
                quantile(waits, .5),
                quantile(waits, .95),
                mean(first),
                mean(later),
                quantile(later, .1),
                wasted / received,
                unseen / received,
                requests / waits.size());
    }

    /**
     * What is shown, relative to what the oracle would show with the same bytes to begin with. Both show whole batches.
     */
    private static double detail(BatchIndex index, SimulatedVisitor.Round r) {
        double possible = whole(index, r.beforeBytes() + r.possibleBytes()) - whole(index, r.beforeBytes());
        return possible <= 0 ? 1 : Math.min(1, (whole(index, r.bytes()) - whole(index, r.beforeBytes())) / possible);
    }

    private static double whole(BatchIndex index, long bytes) {
        int batches = index.batchesWithin(bytes);
        return batches == 0 ? 0 : index.end(batches - 1);
    }

    private static double mean(List<Double> values) {
        return values.stream().mapToDouble(v -> v).average().orElse(0);
    }

    private static double quantile(List<Double> values, double share) {
        double[] sorted = values.stream().mapToDouble(v -> v).sorted().toArray();
        return sorted[Math.min(sorted.length - 1, (int) (share * sorted.length))];
    }
}
