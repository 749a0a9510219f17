package org.jsmesh.store;

/** The time after a failure in which it is not tried again. It doubles with each failure in a row. */
final class Pause {
    private static final long FIRST_MODEL_SECONDS = 60;
    private static final long FIRST_PASSING_SECONDS = 5;
    private static final long LONGEST_SECONDS = 3600;
    private static final int MOST_DOUBLINGS = 12;
    private static final long NANOS = 1_000_000_000L;

    private int failures;
    private boolean passing;
    private long beganNanos;

    Pause() {
        this(0);
    }

    private Pause(int failures) {
        this.failures = failures;
    }

    /** The pause of the next attempt, which knows of the failures before it. */
    synchronized Pause next() {
        return new Pause(failures);
    }

    /** @param isPassing whether the model is not to blame */
    synchronized void begin(boolean isPassing) {
        failures++;
        passing = isPassing;
        beganNanos = System.nanoTime();
    }

    synchronized void reset() {
        failures = 0;
    }

    synchronized boolean isOn() {
        return failures > 0 && System.nanoTime() - beganNanos < length() * NANOS;
    }

    /** What is left of it, rounded up. */
    synchronized long seconds() {
        return failures == 0 ? 0 : length() - (System.nanoTime() - beganNanos) / NANOS;
    }

    private long length() {
        long first = passing ? FIRST_PASSING_SECONDS : FIRST_MODEL_SECONDS;
        return Math.min(LONGEST_SECONDS, first << Math.min(failures - 1, MOST_DOUBLINGS));
    }
}
