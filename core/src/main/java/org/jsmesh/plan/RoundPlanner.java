package org.jsmesh.plan;

import org.jsmesh.archive.BatchIndex;

/**
 * All decisions of a streaming client: the user waits T, and what can arrive within T is asked for in a few requests,
 * one after the other. The deadline decides what is shown; the estimate only bounds what is asked, because every prefix
 * is a mesh. The same for every client; clients only send, read and show.
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
 * A response that the deadline overtakes is not given up: its bytes are the very ones that the next round wants, so
 * that one begins with it, and nothing is wasted or waited for twice. Only when nobody asks on within a grace is the
 * rest given up. It makes no difference then how much of it is on its way already, which on HTTP/2 can be many rounds'
 * worth on a slow link: a stream that is reset there takes back nothing of what the server has handed to its kernel.
 *
 * <p>The first request of all has no estimate and asks for a prefix of {@value #FIRST_BYTES} bytes, which holds header,
 * index and base of most archives and takes 2 s at 64 kbit/s. Every later request is for a fifth more than arrives in
 * what remains of the wait after the time to the first byte; for twice as much while the estimate is a lower bound (see
 * {@link ThroughputEstimator#isUnsaturated()}).
 *
 * <p>What the constants bring was measured with {@code org.jsmesh.simulation}. Pure arithmetic: times are arguments, in
 * milliseconds of any steady clock. Not thread-safe.
 */
public final class RoundPlanner {
    /** What the first request asks for when nothing is known of the link. */
    public static final int FIRST_BYTES = 16384;

    private static final int MOST_REQUESTS = 16;
    /**
     * Asking for a fifth more than should arrive fills the wait in one request, though it is cut down to a batch: what
     * is late belongs to the next round.
     */
    private static final double OVERLAP = 1.2;
    /** While the estimate is a lower bound, this many times what would arrive at it. */
    private static final double PROBE = 2;
    /**
     * No request is for less than arrives in this share of the wait, however little of it is left: the rest is what the
     * next round begins with.
     */
    private static final double LEAST_SHARE = .25;

    private static final double SHORTEST_MILLIS = 50;
    private static final double LOOK_MILLIS = 250;
    /**
     * How long a response is read on after a round, in shares of the wait. Longer would load a link with what nobody
     * has asked for; with half of it twice as many bytes are wasted where rates change, which costs 1 to 3% of the
     * detail.
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
        if (!(waitMillis > 0)) throw new IllegalArgumentException("wait in milliseconds: " + waitMillis);
        this.waitMillis = waitMillis;
        deadlineMillis = startMillis + waitMillis;
        requests = 0;
    }

    /** When the round ends and what is there is shown. */
    public double deadlineMillis() {
        return deadlineMillis;
    }

    /**
     * Whether what is there is to be shown now, though a response is under way. The base is waited for, however long it
     * takes.
     *
     * @param basePresent whether there is anything to show
     */
    public boolean isOver(double nowMillis, boolean basePresent) {
        return basePresent && nowMillis >= deadlineMillis;
    }

    /**
     * The next request of this round, to be asked for when no response is under way.
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

    /** A request was sent. */
    public void sent(double nowMillis) {
        response = new ResponseSamples(nowMillis);
    }

    /**
     * Bytes of the response arrived. Clocks of browsers are coarse, and a page may be suspended: time never runs
     * backwards here.
     */
    public void arrived(double nowMillis, int bytes) {
        if (bytes > 0 && response != null) response.arrived(Math.max(nowMillis, response.endMillis()), bytes);
    }

    /**
     * No more of the response will come: it is complete, broke or was given up. What arrived of it teaches the estimate
     * in each case, because only times between arrivals count.
     *
     * @param fromCache it did not come over the network, and teaches nothing
     */
    public void ended(boolean fromCache) {
        if (!fromCache && response != null) estimator.learn(response);
        response = null;
        lookedMillis = Double.NEGATIVE_INFINITY;
    }

    /**
     * After the round: whether the response under way is read on. One of which nothing has come yet is waited for: its
     * bytes are on their way, and where a round trip takes longer than the wait the next request would come no further.
     *
     * @param bytesLeft of the response
     */
    public boolean mayGoOn(double nowMillis, long bytesLeft) {
        if (bytesLeft == 0 || response == null || response.count() == 0) return true;
        return nowMillis < Math.max(deadlineMillis, response.firstByteMillis()) + GRACE * waitMillis;
    }

    /**
     * The estimate of the throughput, with what the response under way shows so far, which is looked at four times a
     * second; 0 while nothing is known.
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

    /** How much time's worth of bytes to ask for. */
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
