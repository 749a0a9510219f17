package org.jsmesh.batch;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.throughput.ResponseSamples;
import org.jsmesh.throughput.ThroughputEstimator;

/**
 * One round of refinement: the user waits T, and what can arrive within T is asked for in a few requests. The deadline decides what is shown; the estimate only
 * bounds what is asked, because every prefix is a mesh.
 *
 * <pre>
 *     round = new RefinementRound(estimator, now, T)
 *     while ((request = round.next(now, index, received)) != null) {
 *         read the range, feeding the decoder; estimator.learn(response)
 *         at round.deadlineMillis(): show, and keep reading only if round.mayDrain(now, bytes left, response, http2); else cancel
 *     }
 *     show
 * </pre>
 *
 * The first request of all has no estimate and asks for a prefix of {@value #FIRST_BYTES} bytes, which holds header, index and base of most archives and takes 2 s at
 * 64 kbit/s. While the estimate is a lower bound (see {@link ThroughputEstimator#isUnsaturated()}) the next request asks for up to four times as much as would
 * arrive in T / 4; then for a tenth more than arrives in what remains after the time to
 * the first byte. Pure arithmetic: times are arguments. Not thread-safe.
 */
public final class RefinementRound {
    /** What the first request asks for when nothing is known of the link. */
    public static final int FIRST_BYTES = 16384;

    private static final int MOST_REQUESTS = 16;
    /**
     * Asking for a tenth more than should arrive fills the wait in one request: what is late is drained, shown in the next round, and not lost. In simulation this lifts
     * the share of the possible bytes from .955 to .98 at constant rates and saves half a request per round.
     */
    private static final double OVERLAP = 1.1;

    private static final double SHORTEST_MILLIS = 50;

    private final ThroughputEstimator estimator;
    private final double waitMillis;
    private final double deadlineMillis;
    private int requests;

    /**
     * @param startMillis now, on the clock of the estimator's responses
     * @param waitMillis the time T that the user waits
     */
    public RefinementRound(ThroughputEstimator estimator, double startMillis, double waitMillis) {
        if (!(waitMillis > 0)) throw new IllegalArgumentException("wait in milliseconds: " + waitMillis);
        this.estimator = estimator;
        this.waitMillis = waitMillis;
        this.deadlineMillis = startMillis + waitMillis;
    }

    /** When the round ends and what is there is shown. */
    public double deadlineMillis() {
        return deadlineMillis;
    }

    /**
     * The next request of this round.
     *
     * @param index of the archive, or null while it has not arrived
     * @param receivedBytes bytes of the archive held, partial batches included
     * @return null when the round asks for no more: its time is used up, or everything has arrived
     */
    public BatchRequest next(double nowMillis, BatchIndex index, long receivedBytes) {
        if (index != null && receivedBytes >= index.archiveBytes()) return null;
        boolean baseMissing = index == null || receivedBytes < index.end(0);
        double remaining = deadlineMillis - nowMillis;
        if (!baseMissing && !hasTime(remaining)) return null;
        requests++;
        if (index == null) return new BatchRequest(receivedBytes, receivedBytes + FIRST_BYTES, 0, -1, 0, 0);
        if (!estimator.isKnown()) {
            long prefix = Math.max(FIRST_BYTES - receivedBytes, 0);
            return request(index, receivedBytes, prefix, 1000);
        }
        long bytesPerSecond = (long) Math.min(estimator.bytesPerSecond(), 1e15);
        return request(index, receivedBytes, bytesPerSecond, (int) Math.min(askMillis(Math.max(remaining, 0)), 1e9));
    }

    /**
     * At the deadline: whether a response is better read to its end in the background than cancelled. Its bytes count for the next round. One of which nothing
     * has come yet is waited for: its bytes are on their way, and where a round trip takes longer than the wait the next request would come no further.
     *
     * @param bytesLeft of the response
     * @param response what arrived of it so far
     * @param http2 cancelling a stream of HTTP/2 wastes what is on the wire and slows the next requests; closing a connection of HTTP/1.1 costs 22–40 kB
     */
    public boolean mayDrain(double nowMillis, long bytesLeft, ResponseSamples response, boolean http2) {
        if (response.count() == 0) return true;
        double bytesPerSecond = response.bytes() * 1000 / Math.max(1, nowMillis - response.startMillis());
        return bytesLeft == 0 || bytesLeft * 1000.0 / bytesPerSecond <= graceMillis(http2);
    }

    /** How long a response may go on after the deadline, or after its first byte when that comes later. */
    public double graceMillis(boolean http2) {
        return (http2 ? 0.5 : 0.25) * waitMillis;
    }

    private boolean hasTime(double remaining) {
        if (requests == 0) return true;
        if (requests >= MOST_REQUESTS || remaining <= SHORTEST_MILLIS) return false;
        return remaining > 1.5 * estimator.timeToFirstByteMillis();
    }

    /** How much time's worth of bytes to ask for. */
    private double askMillis(double remaining) {
        double use = Math.max(remaining - estimator.timeToFirstByteMillis(), remaining / 4);
        if (!estimator.isUnsaturated()) return OVERLAP * use;
        double probe = 4 * Math.min(use, waitMillis / 4);
        return use < waitMillis / 3 ? probe / 3 : probe;
    }

    private static BatchRequest request(BatchIndex index, long receivedBytes, long bytesPerSecond, int askMillis) {
        int fromBatch = index.batchesWithin(receivedBytes);
        int endBatch = BatchPlanner.planFromByte(index, receivedBytes, bytesPerSecond, askMillis);
        return new BatchRequest(receivedBytes, index.end(endBatch - 1), fromBatch, endBatch, bytesPerSecond, askMillis);
    }
}
