package org.jsmesh.load;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.batch.BatchRequest;
import org.jsmesh.batch.RefinementRound;
import org.jsmesh.throughput.ResponseSamples;
import org.jsmesh.throughput.ThroughputEstimator;

/** The project's planner as a viewer uses it; the one place that knows its classes. */
final class Planning {
    private final ThroughputEstimator estimator = new ThroughputEstimator();
    private RefinementRound round;
    private ResponseSamples response;
    private Boolean drained;

    void beginRound(double nowMillis, double waitMillis) {
        round = new RefinementRound(estimator, nowMillis, waitMillis);
        drained = null;
        if (response != null) response = new ResponseSamples(nowMillis);
    }

    /** When the round ends and what is there is shown. */
    double deadlineMillis() {
        return round.deadlineMillis();
    }

    /** The next request of the round, or null. */
    BatchRequest next(double nowMillis, BatchIndex index, long receivedBytes) {
        return round.next(nowMillis, index, receivedBytes);
    }

    void sent(double nowMillis) {
        response = new ResponseSamples(nowMillis);
    }

    void arrived(double nowMillis, int bytes) {
        if (bytes > 0) response.arrived(Math.max(nowMillis, response.endMillis()), bytes);
    }

    /** The response is complete, or broke, or was given up. */
    void ended() {
        if (response != null) estimator.learn(response);
        response = null;
    }

    /** After the round: whether the response under way is read on. */
    boolean mayGoOn(double nowMillis, long bytesLeft) {
        if (drained == null) drained = round.mayDrain(nowMillis, bytesLeft, response, false);
        if (!drained) return false;
        if (response.count() == 0) return true;
        return nowMillis < Math.max(round.deadlineMillis(), response.firstByteMillis()) + round.graceMillis(false);
    }
}
