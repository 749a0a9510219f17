package org.jsmesh.web;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.batch.BatchRequest;
import org.jsmesh.batch.RefinementRound;
import org.jsmesh.throughput.ResponseSamples;
import org.jsmesh.throughput.ThroughputEstimator;

/** The planner of the other clients behind plain numbers: rounds, responses and the estimate. Not thread-safe. */
final class RoundPlanner {
    private final ThroughputEstimator estimator = new ThroughputEstimator();
    private RefinementRound round;
    private ResponseSamples response;

    void beginRound(double now, double waitMillis) {
        round = new RefinementRound(estimator, now, waitMillis);
    }

    String nextRequest(double now, BatchIndex index, long receivedBytes) {
        BatchRequest request = round.next(now, index, receivedBytes);
        if (request == null) return null;
        return request.fromByte()
                + " "
                + request.endByte()
                + " "
                + request.fromBatch()
                + " "
                + request.endBatch()
                + " "
                + request.bytesPerSecond()
                + " "
                + request.waitMillis();
    }

    void beginResponse(double now) {
        response = new ResponseSamples(now);
    }

    /** Clocks of browsers are coarse, and a page may be suspended: time never runs backwards here. */
    void arrived(double now, int bytes) {
        if (bytes > 0) response.arrived(Math.max(now, response.endMillis()), bytes);
    }

    void endResponse(boolean cached) {
        if (!cached) estimator.learn(response);
    }

    boolean mayDrain(double now, long bytesLeft, boolean http2) {
        return round.mayDrain(now, bytesLeft, response, http2);
    }

    double bytesPerSecond() {
        return estimator.isKnown() ? estimator.bytesPerSecond() : 0;
    }
}
