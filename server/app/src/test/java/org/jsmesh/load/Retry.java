package org.jsmesh.load;

import java.util.Random;

/** When a viewer tries again after a failure. Waits grow with every failure in a row. */
final class Retry {
    private static final double BACKOFF_MILLIS = 250;
    private static final int MOST_DOUBLINGS = 4;
    private static final int MOST_FAILURES = 60;
    private static final double LONGEST_REFUSAL_SECONDS = 5;

    private final Random random;
    private double atMillis;
    private int failures;

    /** @param random spreads the waits, so that viewers do not come back together */
    Retry(Random random) {
        this.random = random;
    }

    /** Nothing is asked for before that time. */
    double atMillis() {
        return atMillis;
    }

    void succeeded() {
        failures = 0;
    }

    /** Plans another try. False when there were too many in a row. */
    boolean failed(double nowMillis) {
        if (++failures > MOST_FAILURES) return false;
        double millis = BACKOFF_MILLIS * (1 << Math.min(failures - 1, MOST_DOUBLINGS));
        atMillis = nowMillis + millis * (.5 + random.nextDouble());
        return true;
    }

    /** @param retryAfter what the server said in its {@code Retry-After}, in seconds, or the empty text */
    void refused(double nowMillis, String retryAfter) {
        double seconds = retryAfter.isEmpty() ? 1 : Math.min(LONGEST_REFUSAL_SECONDS, Double.parseDouble(retryAfter));
        atMillis = nowMillis + seconds * 1000 * (.5 + random.nextDouble());
    }
}
