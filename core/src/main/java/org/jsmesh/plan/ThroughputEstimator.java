package org.jsmesh.plan;

/**
 * Estimates the throughput of a connection and the time to the first byte from the responses seen so far: the
 * "effective bandwidth" that section 5.2 of Chen and Nishita 2002 computes from file size, transmission time and the
 * bandwidth before.
 *
 * <p>Three things make a plain bytes ÷ time wrong. A short response is mostly latency, so the time to the first byte is
 * kept apart. A response is measured in <b>windows</b> of at least 100 ms (and at least the time to its first byte) and
 * 8 KiB. Windows begin after the first arrival, because its bytes were buffered on the way. TCP starts slowly, so
 * leading windows are dropped while the next is more than 1.4 times faster. A response that has no window, or one short
 * window, or still grows at its end does not show what the link can do. The estimate is then a lower bound,
 * {@link #isUnsaturated()}, and a planner may ask for more than rate × time.
 *
 * <p>The estimate is the larger of two rates: an average by time with a half-life of 1 s, and the rate of the last
 * response. It rises quickly and falls slowly. Video players do the opposite, because their picture stalls when they
 * ask for too much. Here every prefix is a picture, what is late belongs to the next round, and only what was not asked
 * for is lost.
 *
 * <p>Pure arithmetic on the arguments: no clock, no float, the same results on every platform. Not thread-safe.
 */
public final class ThroughputEstimator {
    private static final double WINDOW_MILLIS = 100;
    private static final long WINDOW_BYTES = 8192;
    /** A factor between neighbouring windows above which the connection still grows. */
    private static final double GROWTH = 1.4;
    /** A window shorter than this many times to first byte may lie wholly within the slow start. */
    private static final double SETTLED = 4;
    /** The first response also pays for a name look-up, a handshake and a cold program. */
    private static final double FIRST_RESPONSE_MILLIS = 200;

    private final MovingAverage average = new MovingAverage(1000);
    private double lastBytesPerSecond;
    private double timeToFirstByteMillis;
    private boolean unsaturated = true;
    private int responses;

    /**
     * Learns from one response that came over the network. Responses from a cache must not be learned. A response
     * without bytes teaches nothing.
     *
     * @param response all arrivals of it
     */
    public void learn(ResponseSamples response) {
        if (response.count() == 0) return;
        double latency = response.firstByteMillis() - response.startMillis();
        learnLatency(latency);
        responses++;
        learnWindows(response, responses == 1 ? Math.min(latency, FIRST_RESPONSE_MILLIS) : latency);
    }

    /**
     * The same for callers that hold arrays.
     *
     * @param startMillis when the request was sent
     * @param arrivalMillis when each portion of the body arrived, ascending
     * @param arrivalBytes size of each portion, positive
     * @param count portions in the arrays
     */
    public void learn(double startMillis, double[] arrivalMillis, int[] arrivalBytes, int count) {
        ResponseSamples response = new ResponseSamples(startMillis);
        for (int i = 0; i < count; i++) response.arrived(arrivalMillis[i], arrivalBytes[i]);
        learn(response);
    }

    /**
     * Tells the value that {@link #bytesPerSecond()} would have if a response that is still under way ended now. This
     * estimator does not change.
     *
     * @param underWay the arrivals so far
     * @return bytes per second
     */
    public double bytesPerSecondWith(ResponseSamples underWay) {
        ThroughputEstimator other = new ThroughputEstimator();
        other.average.copy(average);
        other.lastBytesPerSecond = lastBytesPerSecond;
        other.responses = responses;
        other.learn(underWay);
        return other.bytesPerSecond();
    }

    /** {@return true when at least one response was learned} */
    public boolean isKnown() {
        return responses > 0;
    }

    /** {@return the estimate; 0 before the first response} */
    public double bytesPerSecond() {
        return Math.max(average.value(), lastBytesPerSecond);
    }

    /** {@return the average time from request to the first byte of the body; 0 before the first response} */
    public double timeToFirstByteMillis() {
        return timeToFirstByteMillis;
    }

    /**
     * {@return true when the estimate is only a lower bound, because there was no response yet or the last one was too
     * short to fill the link}
     */
    public boolean isUnsaturated() {
        return unsaturated;
    }

    private void learnLatency(double latencyMillis) {
        if (responses == 0) timeToFirstByteMillis = Math.min(latencyMillis, FIRST_RESPONSE_MILLIS);
        else timeToFirstByteMillis = (timeToFirstByteMillis + latencyMillis) / 2;
    }

    private void learnWindows(ResponseSamples response, double latencyMillis) {
        double shortest = Math.max(WINDOW_MILLIS, latencyMillis);
        double[] rates = new double[response.count()];
        double[] lengths = new double[response.count()];
        int windows = 0;
        double begin = response.firstByteMillis();
        long inWindow = 0;
        for (int i = 1; i < response.count(); i++) {
            inWindow += response.byteCount(i);
            double length = response.atMillis(i) - begin;
            if (length < shortest || inWindow < WINDOW_BYTES) continue;
            rates[windows] = inWindow * 1000 / length;
            lengths[windows++] = length;
            begin = response.atMillis(i);
            inWindow = 0;
        }
        if (windows == 0) {
            // The rest of a batch says next to nothing about the link.
            if (responses > 1 && response.bytes() < WINDOW_BYTES) return;
            double millis = Math.max(1, response.endMillis() - response.startMillis());
            lastBytesPerSecond = response.bytes() * 1000 / millis;
            average.add(lastBytesPerSecond, millis);
            unsaturated = true;
            return;
        }
        int first = 0;
        while (first + 1 < windows && rates[first + 1] > GROWTH * rates[first]) first++;
        double bytes = 0;
        double millis = 0;
        for (int i = first; i < windows; i++) {
            average.add(rates[i], lengths[i]);
            bytes += rates[i] * lengths[i];
            millis += lengths[i];
        }
        lastBytesPerSecond = bytes / millis;
        unsaturated =
                windows == 1 ? lengths[0] < SETTLED * latencyMillis : rates[windows - 1] > GROWTH * rates[windows - 2];
    }
}
