package org.jsmesh.plan;

import java.util.Arrays;

/**
 * When the bytes of one response arrived. Filled while the response is read, then given to
 * {@link ThroughputEstimator#learn(ResponseSamples)}.
 *
 * <p>Times are milliseconds of any steady clock, the same for all calls; fractions matter. Not thread-safe.
 */
public final class ResponseSamples {
    private final double startMillis;
    private double[] atMillis = new double[32];
    private int[] byteCounts = new int[32];
    private int count;
    private long bytes;
    private double endMillis;

    /** @param startMillis when the request was sent */
    public ResponseSamples(double startMillis) {
        this.startMillis = startMillis;
        this.endMillis = startMillis;
    }

    /**
     * Notes that some bytes of the body arrived.
     *
     * @param nowMillis time of the arrival
     * @param byteCount at least 1
     * @throws IllegalArgumentException when the time is earlier than the last arrival, or the count is not positive
     */
    public void arrived(double nowMillis, int byteCount) {
        if (!(nowMillis >= endMillis))
            throw new IllegalArgumentException("arrival at " + WholeNumber.of(nowMillis) + " ms after one at "
                    + WholeNumber.of(endMillis) + " ms");
        if (byteCount <= 0) throw new IllegalArgumentException("arrival of " + byteCount + " bytes");
        if (count == atMillis.length) {
            atMillis = Arrays.copyOf(atMillis, 2 * count);
            byteCounts = Arrays.copyOf(byteCounts, 2 * count);
        }
        atMillis[count] = nowMillis;
        byteCounts[count++] = byteCount;
        bytes += byteCount;
        endMillis = nowMillis;
    }

    /** {@return when the request was sent} */
    public double startMillis() {
        return startMillis;
    }

    /** {@return when the first byte of the body arrived; the start when none has} */
    public double firstByteMillis() {
        return count == 0 ? startMillis : atMillis[0];
    }

    /** {@return when the last byte so far arrived; the start when none has} */
    public double endMillis() {
        return endMillis;
    }

    /** {@return the bytes of the body so far} */
    public long bytes() {
        return bytes;
    }

    /** {@return the number of arrivals so far} */
    public int count() {
        return count;
    }

    /**
     * Tells the time of an arrival.
     *
     * @param arrival 0 to {@code count() - 1}
     * @return milliseconds
     */
    public double atMillis(int arrival) {
        return atMillis[arrival];
    }

    /**
     * Tells the bytes of an arrival.
     *
     * @param arrival 0 to {@code count() - 1}
     * @return at least 1
     */
    public int byteCount(int arrival) {
        return byteCounts[arrival];
    }
}
