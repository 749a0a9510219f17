package org.jsmesh.app;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.batch.BatchRequest;
import org.jsmesh.batch.RefinementRound;
import org.jsmesh.throughput.ResponseSamples;
import org.jsmesh.throughput.ThroughputEstimator;

/**
 * A visitor on a link of constant rate, in virtual time: the planner and the estimator that the clients use, without a network. Deterministic.
 */
final class Simulation {
    private static final double PORTION_MILLIS = 10;

    private final BatchIndex index;
    private final double bytesPerMilli;
    private final double roundTripMillis;
    private final ThroughputEstimator estimator = new ThroughputEstimator();
    private double now;
    private long received;
    private boolean connected;

    /**
     * What the visitor sees when a round ends.
     *
     * @param waitMillis from asking to seeing
     * @param requests sent in the round
     * @param bytes held when it ends
     * @param batches shown when it ends
     * @param faces of the mesh shown
     * @param errorMean of that mesh, in % of the diagonal
     * @param errorBound what no point of it is expected to be further off, likewise
     */
    record Row(
            double waitMillis, int requests, long bytes, int batches, int faces, double errorMean, double errorBound) {}

    /**
     * @param bitsPerSecond of the link
     * @param roundTripMillis from a request to the first byte of its response; a new connection takes one more
     */
    Simulation(BatchIndex index, double bitsPerSecond, double roundTripMillis) {
        this.index = index;
        this.bytesPerMilli = bitsPerSecond / 8000;
        this.roundTripMillis = roundTripMillis;
    }

    /** Rounds of the same wait until the original is shown, at most {@code most}. */
    List<Row> run(double waitMillis, int most) {
        return run(waitMillis, most, -1);
    }

    /** The same, but the visitor asks for no more when the bound of the error is at or below a value. */
    List<Row> run(double waitMillis, int most, double goodBound) {
        List<Row> rows = new ArrayList<>();
        long shown = 0;
        while (rows.size() < most && shown < index.archiveBytes()) {
            Row row = refine(waitMillis);
            shown = row.bytes();
            rows.add(row);
            if (row.errorBound() <= goodBound) break;
        }
        return rows;
    }

    private Row refine(double waitMillis) {
        double begin = now;
        RefinementRound round = new RefinementRound(estimator, begin, waitMillis);
        Showing showing = new Showing(round.deadlineMillis());
        int requests = 0;
        while (!showing.done) {
            BatchRequest request = round.next(now, received < headerBytes() ? null : index, received);
            if (request == null) break;
            requests++;
            read(request, round, showing);
        }
        if (!showing.done) showing.show(now);
        // A response that was drained after the deadline belongs to the next round, which begins when the user asks
        // again.
        int batches = index.batchesWithin(showing.bytes);
        return new Row(
                showing.millis - begin,
                requests,
                showing.bytes,
                batches,
                index.faces(batches - 1),
                index.errorMean(batches - 1),
                index.errorBound(batches - 1));
    }

    private void read(BatchRequest request, RefinementRound round, Showing showing) {
        ResponseSamples response = new ResponseSamples(now);
        long end = Math.min(request.endByte(), index.archiveBytes());
        now += connected ? roundTripMillis : 2 * roundTripMillis;
        connected = true;
        if (now > showing.deadlineMillis && received >= index.end(0) && !showing.done)
            showing.show(showing.deadlineMillis);
        double credit = 0;
        while (received < end) {
            boolean late = now >= showing.deadlineMillis && received >= index.end(0);
            if (late && !showing.done) showing.show(now);
            if (late && !round.mayDrain(now, end - received, response, false)) {
                connected = false;
                break;
            }
            now += PORTION_MILLIS;
            credit += bytesPerMilli * PORTION_MILLIS;
            int portion = (int) Math.min(end - received, (long) credit);
            if (portion == 0) continue;
            credit -= portion;
            received += portion;
            response.arrived(now, portion);
        }
        estimator.learn(response);
    }

    /** How much must be there before the index can be read. The index fills most of what is before the base. */
    private long headerBytes() {
        return Math.min(index.end(0), RefinementRound.FIRST_BYTES);
    }

    /** What is shown at the deadline, or at the end of a round that has nothing more to ask for. */
    private final class Showing {
        private final double deadlineMillis;
        private double millis;
        private long bytes;
        private boolean done;

        Showing(double deadlineMillis) {
            this.deadlineMillis = deadlineMillis;
        }

        void show(double atMillis) {
            millis = atMillis;
            bytes = received;
            done = true;
        }
    }
}
