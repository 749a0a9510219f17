package org.jsmesh.simulation;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.plan.BatchRequest;
import org.jsmesh.plan.RoundPlanner;

/** A client of jSM, which does what the planner says. */
final class PlannedClient implements SimulatedClient {
    private final RoundPlanner planner = new RoundPlanner();

    @Override
    public void beginRound(double nowMillis, double waitMillis) {
        planner.beginRound(nowMillis, waitMillis);
    }

    @Override
    public long next(double nowMillis, BatchIndex index, long receivedBytes) {
        BatchRequest request = planner.next(nowMillis, index, receivedBytes);
        return request == null ? -1 : request.endByte();
    }

    @Override
    public void sent(double nowMillis) {
        planner.sent(nowMillis);
    }

    @Override
    public void arrived(double nowMillis, int bytes) {
        planner.arrived(nowMillis, bytes);
    }

    @Override
    public void ended(double nowMillis) {
        planner.ended(false);
    }

    @Override
    public boolean isOver(double nowMillis, boolean basePresent) {
        return planner.isOver(nowMillis, basePresent);
    }

    @Override
    public boolean mayGoOn(double nowMillis, long bytesLeft) {
        return planner.mayGoOn(nowMillis, bytesLeft);
    }
}
