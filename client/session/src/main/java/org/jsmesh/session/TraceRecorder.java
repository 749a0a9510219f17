package org.jsmesh.session;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.BatchIndex;

/** Keeps the rows of a session's trace. Thread-safe. */
final class TraceRecorder {
    private final List<RoundReport> rounds = new ArrayList<>();
    private final List<RequestReport> requests = new ArrayList<>();
    private RequestReport underWay;
    private double calledMillis;
    private long plannedWaitMillis;
    private long shownBytes;
    private long plannedEnd;

    synchronized void beginRound(double called, long plannedWait, long receivedBytes) {
        calledMillis = called;
        plannedWaitMillis = plannedWait;
        plannedEnd = receivedBytes;
    }

    synchronized void planned(long endByte) {
        plannedEnd = Math.max(plannedEnd, endByte);
    }

    synchronized RoundReport endRound(double nowMillis, ReceivedArchive archive, double bytesPerSecond) {
        BatchIndex index = archive.index();
        int last = archive.batches() - 1;
        plannedEnd = Math.max(plannedEnd, archive.bytes());
        if (index != null) plannedEnd = Math.min(plannedEnd, index.archiveBytes());
        RoundReport round = new RoundReport(
                Math.round(nowMillis - calledMillis),
                plannedWaitMillis,
                plannedEnd - shownBytes,
                archive.bytes() - shownBytes,
                (long) bytesPerSecond,
                archive.batches(),
                last < 0 ? 0 : index.faces(last),
                last < 0 ? 0 : index.errorMean(last));
        shownBytes = archive.bytes();
        rounds.add(round);
        return round;
    }

    /** A request has ended. */
    synchronized void request(RequestReport request) {
        requests.add(request);
        underWay = null;
    }

    /** Records what the request under way has brought so far. */
    synchronized void underWay(RequestReport request) {
        underWay = request;
    }

    synchronized SessionTrace snapshot() {
        List<RequestReport> all = new ArrayList<>(requests);
        if (underWay != null) all.add(underWay);
        return new SessionTrace(rounds, all);
    }
}
