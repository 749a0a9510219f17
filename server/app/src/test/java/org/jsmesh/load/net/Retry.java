package org.jsmesh.load.net;

import java.util.Random;

/** When a viewer tries again after a failure. Waits grow with every failure in a row. */
public final class Retry {
    private static final double BACKOFF_MILLIS = 250;
    private static final int MOST_DOUBLINGS = 4;
    private static final int MOST_FAILURES = 60;
    private static final double LONGEST_REFUSAL_SECONDS = 5;

    private final Random random;
    private double atMillis;
    private int failures;

    /** @param random spreads the waits, so that viewers do not come back together */
    public Retry(Random random) {
        this.random = random;
    }

    /** Nothing is asked for before that time. */
    public double atMillis() {
        return atMillis;
    }

    public void succeeded() {
        failures = 0;
    }

    /** Plans another try. False when there were too many in a row. */
    public boolean failed(double nowMillis) {
        if (++failures > MOST_FAILURES) return false;
        double millis = BACKOFF_MILLIS * (1 << Math.min(failures - 1, MOST_DOUBLINGS));
        atMillis = nowMillis + millis * (.5 + random.nextDouble());
        return true;
    }

    /** @param retryAfter what the server said in its {@code Retry-After}, in seconds, or the empty text */
    public void refused(double nowMillis, String retryAfter) {
        double seconds = retryAfter.isEmpty() ? 1 : Math.min(LONGEST_REFUSAL_SECONDS, Double.parseDouble(retryAfter));
        atMillis = nowMillis + seconds * 1000 * (.5 + random.nextDouble());
    }
}
