package org.jsmesh.load.net;

/**
 * The link of one viewer: a rate and a round trip. It is kept by reading no faster from the socket, whose small buffer
 * then holds the server back. What a busy machine reads late it may catch up with, as bytes that wait have crossed the
 * link already; time in which nothing waits is lost. Not thread-safe.
 */
public final class Link {
    /** How often a socket is read while bytes wait: seldom enough for hundreds of viewers on one thread. */
    private static final double TICK_MILLIS = 20;

    private final double bytesPerMilli;
    private final double roundTripMillis;
    private double credit;
    private double creditedMillis;
    private double blockedUntilMillis;
    private boolean drained = true;

    public Link(double bitsPerSecond, double roundTripMillis) {
        this.bytesPerMilli = bitsPerSecond / 8000;
        this.roundTripMillis = roundTripMillis;
    }

    public double roundTripMillis() {
        return roundTripMillis;
    }

    /** Bytes that the link carries in so many milliseconds. */
    public double carries(double millis) {
        return Math.max(0, millis) * bytesPerMilli;
    }

    /** A receive buffer that the rate fills in a few ticks. */
    int bufferBytes() {
        return (int) Math.max(4096, Math.min(1 << 19, 3 * TICK_MILLIS * bytesPerMilli));
    }

    /** Nothing passes before that time. */
    public void blockUntil(double millis) {
        blockedUntilMillis = millis;
    }

    public double blockedUntilMillis() {
        return blockedUntilMillis;
    }

    /** How many bytes may be read now; 0 for none before {@link #readyMillis}. */
    int allowance(double nowMillis) {
        if (nowMillis < blockedUntilMillis) return 0;
        double from = Math.max(creditedMillis, blockedUntilMillis);
        credit += Math.max(0, nowMillis - from) * bytesPerMilli;
        creditedMillis = nowMillis;
        if (drained) credit = Math.min(credit, portion());
        return credit < portion() ? 0 : (int) Math.min(credit, 1 << 30);
    }

    /** When the next bytes may be read. */
    double readyMillis() {
        double credited = creditedMillis + (portion() - credit) / bytesPerMilli;
        return Math.max(credited + .01, blockedUntilMillis);
    }

    /**
     * Bytes were read.
     *
     * @param drained nothing was left in the socket
     */
    void took(int bytes, boolean drained) {
        credit -= bytes;
        this.drained = drained;
    }

    private double portion() {
        return Math.max(256, TICK_MILLIS * bytesPerMilli);
    }
}
