package org.jsmesh.session;

/** Milliseconds, with fractions, since it was made; never set back. Thread-safe. */
final class SteadyClock {
    private final long startNanos = System.nanoTime();

    double millis() {
        return (System.nanoTime() - startNanos) / 1e6;
    }
}
