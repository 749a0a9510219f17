package org.jsmesh.load;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.plan.BatchRequest;
import org.jsmesh.plan.RoundPlanner;

/** The project's planner as a viewer uses it; the one place that knows its classes. */
final class Planning {
    private final RoundPlanner planner = new RoundPlanner();

    void beginRound(double nowMillis, double waitMillis) {
        planner.beginRound(nowMillis, waitMillis);
    }

    /** When the round ends and what is there is shown. */
    double deadlineMillis() {
        return planner.deadlineMillis();
    }

    /** The next request of the round, or null. */
    BatchRequest next(double nowMillis, BatchIndex index, long receivedBytes) {
        return planner.next(nowMillis, index, receivedBytes);
    }

    void sent(double nowMillis) {
        planner.sent(nowMillis);
    }

    void arrived(double nowMillis, int bytes) {
        planner.arrived(nowMillis, bytes);
    }

    /** The response is complete, or broke, or was given up. */
    void ended() {
        planner.ended(false);
    }

    /** After the round: whether the response under way is read on. */
    boolean mayGoOn(double nowMillis, long bytesLeft) {
        return planner.mayGoOn(nowMillis, bytesLeft);
    }
}
