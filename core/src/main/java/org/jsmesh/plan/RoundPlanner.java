package org.jsmesh.plan;

import org.jsmesh.archive.BatchIndex;

/**
 * Makes all decisions of a streaming client. The user waits T. The client asks for what can arrive within T, in a few
 * requests, one after the other. The deadline decides what is shown. The estimate only bounds what is asked for,
 * because every prefix is a mesh. Every client uses this class, and only sends, reads and shows.
 *
 * <pre>
 *     planner.beginRound(now, T)
 *     while no response is under way or until planner.isOver(now, base present):
 *         if no response is under way: request = planner.next(now, index, received); none: the round is over; else send it, planner.sent(now)
 *         read: planner.arrived(now, bytes); at its end: planner.ended(cached)
 *     show
 *     until the next round begins, which takes the response over: read on while planner.mayGoOn(now, bytes left), else give up and planner.ended(false)
 * </pre>
 *
 * A client does not give up a response that is under way at the deadline: its bytes are the very ones that the next
 * round wants. The next round begins with it, so nothing is wasted or waited for twice. The client gives the rest up
 * only when nobody asks for another round within a grace. Giving up late keeps the waste small on HTTP/2, where a reset
 * stream takes back nothing that the server has handed to its kernel; on a slow link this can be many rounds' worth.
 *
 * <p>The first request of all has no estimate and asks for a prefix of {@value #FIRST_REQUEST_BYTES} bytes. The prefix
 * holds the opening, the base and more of most archives and takes 2 s at 64 kbit/s. Every later request is for a fifth
 * more than arrives in what remains of the wait after the time to the first byte. While the estimate is a lower bound
 * (see {@link ThroughputEstimator#isUnsaturated()}), it is for twice as much. No request is for less than arrives in a
 * quarter of the wait.
 *
 * <p>The effect of the constants was measured with {@code org.jsmesh.simulation}. The class is pure arithmetic: times
 * are arguments, in milliseconds of any steady clock. Not thread-safe.
 */
public final class RoundPlanner {
    /** Bytes that the first request asks for, when nothing is known of the link. */
    public static final int FIRST_REQUEST_BYTES = 16384;

    private static final int MOST_REQUESTS = 16;
    /**
     * Factor from what should arrive to what is asked for. It fills the wait in one request, although the request is
     * cut down to whole batches. What is late belongs to the next round.
     */
    private static final double OVERLAP = 1.2;
    /** The same factor while the estimate is a lower bound. */
    private static final double PROBE = 2;
    /**
     * No request is for less than arrives in this share of the wait, however little of the wait is left. The next round
     * begins with what is late.
     */
    private static final double LEAST_SHARE = .25;

    private static final double SHORTEST_MILLIS = 50;
    private static final double LOOK_MILLIS = 250;
    /**
     * How long a client reads a response on after a round, in shares of the wait. A longer time would load a link with
     * what nobody has asked for. With half of this time, twice as many bytes are wasted where rates change, which costs
     * 1 to 3% of the detail.
     */
    private static final double GRACE = 1;

    private final ThroughputEstimator estimator = new ThroughputEstimator();
    private ResponseSamples response;
    private double waitMillis;
    private double deadlineMillis;
    private int requests;
    private double lookedMillis = Double.NEGATIVE_INFINITY;
    private double lookedBytesPerSecond;

    /**
     * A user starts to wait. A response that is still under way belongs to this round.
     *
     * @param startMillis now, or when the user asked
     * @param waitMillis the time T that the user waits
     */
    public void beginRound(double startMillis, double waitMillis) {
        if (!(waitMillis > 0))
            throw new IllegalArgumentException("wait in milliseconds: " + WholeNumber.of(waitMillis));
        this.waitMillis = waitMillis;
        deadlineMillis = startMillis + waitMillis;
        requests = 0;
    }

    /** {@return when the round ends and what is there is shown} */
    public double deadlineMillis() {
        return deadlineMillis;
    }

    /**
     * Whether to show what is there now, even if a response is under way. A client waits for the base, however long it
     * takes.
     *
     * @param nowMillis time of the call
     * @param basePresent whether there is anything to show
     * @return true when the round is over
     */
    public boolean isOver(double nowMillis, boolean basePresent) {
        return basePresent && nowMillis >= deadlineMillis;
    }

    /**
     * Plans the next request of this round. Ask for it when no response is under way.
     *
     * @param nowMillis time of the call
     * @param index of the archive as far as it is known, or null while the opening has not arrived
     * @param receivedBytes bytes of the archive held, partial batches included
     * @return null when the round asks for no more: its time is used up, or everything has arrived
     */
    public BatchRequest next(double nowMillis, BatchIndex index, long receivedBytes) {
        if (index != null && receivedBytes >= index.archiveBytes()) return null;
        boolean baseMissing = index == null || receivedBytes < index.end(0);
        double remaining = deadlineMillis - nowMillis;
        if (!baseMissing && !hasTime(remaining)) return null;
        requests++;
        if (index == null) return new BatchRequest(receivedBytes, receivedBytes + FIRST_REQUEST_BYTES, 0, -1, 0, 0);
        if (!estimator.isKnown()) {
            long prefix = Math.max(FIRST_REQUEST_BYTES - receivedBytes, 0);
            return request(index, receivedBytes, prefix, 1000);
        }
        long bytesPerSecond = (long) Math.min(estimator.bytesPerSecond(), 1e15);
        return request(index, receivedBytes, bytesPerSecond, (int) Math.min(askMillis(Math.max(remaining, 0)), 1e9));
    }

    /**
     * Notes that a request was sent.
     *
     * @param nowMillis time of the call
     */
    public void sent(double nowMillis) {
        response = new ResponseSamples(nowMillis);
    }

    /**
     * Notes that bytes of the response arrived. Clocks of browsers are coarse, and a page may be suspended: time never
     * runs backwards here.
     *
     * @param nowMillis time of the call
     * @param bytes number of bytes
     */
    public void arrived(double nowMillis, int bytes) {
        if (bytes > 0 && response != null) response.arrived(Math.max(nowMillis, response.endMillis()), bytes);
    }

    /**
     * No more of the response will come: it is complete, broke or was given up. The estimate learns from what arrived
     * of it in each case, because only times between arrivals count.
     *
     * @param fromCache whether it did not come over the network; the estimate then learns nothing
     */
    public void ended(boolean fromCache) {
        if (!fromCache && response != null) estimator.learn(response);
        response = null;
        lookedMillis = Double.NEGATIVE_INFINITY;
    }

    /**
     * After the round: whether to read the response under way on. A client waits for a response that has not begun: its
     * bytes are on their way, and where a round trip takes longer than the wait, another request would be no faster.
     *
     * @param nowMillis time of the call
     * @param bytesLeft of the response
     * @return true to read on, false to give the response up
     */
    public boolean mayGoOn(double nowMillis, long bytesLeft) {
        if (bytesLeft == 0 || response == null || response.count() == 0) return true;
        return nowMillis < Math.max(deadlineMillis, response.firstByteMillis()) + GRACE * waitMillis;
    }

    /**
     * Estimates the throughput, including the response under way as it was at the last of four looks a second.
     *
     * @param nowMillis time of the call
     * @return bytes per second; 0 while nothing is known
     */
    public double bytesPerSecond(double nowMillis) {
        if (response == null) return estimator.bytesPerSecond();
        if (nowMillis - lookedMillis >= LOOK_MILLIS) {
            lookedMillis = nowMillis;
            lookedBytesPerSecond = estimator.bytesPerSecondWith(response);
        }
        return lookedBytesPerSecond;
    }

    private boolean hasTime(double remaining) {
        if (requests == 0) return true;
        if (requests >= MOST_REQUESTS || remaining <= SHORTEST_MILLIS) return false;
        return remaining > 1.5 * estimator.timeToFirstByteMillis();
    }

    /** The time in which the bytes to ask for would arrive. */
    private double askMillis(double remaining) {
        double use = Math.max(remaining - estimator.timeToFirstByteMillis(), remaining / 4);
        return (estimator.isUnsaturated() ? PROBE : OVERLAP) * Math.max(use, LEAST_SHARE * waitMillis);
    }

    private static BatchRequest request(BatchIndex index, long receivedBytes, long bytesPerSecond, int askMillis) {
        int fromBatch = index.batchesWithin(receivedBytes);
        int endBatch = BatchPlanner.planFromByte(index, receivedBytes, bytesPerSecond, askMillis);
        return new BatchRequest(receivedBytes, index.end(endBatch - 1), fromBatch, endBatch, bytesPerSecond, askMillis);
    }
}
