package org.jsmesh.codec.connectivity;

/** Runs two halves of an encoder's work side by side. */
public interface PairRunner {
    /**
     * Runs both and returns when they are done. The second may run in another thread at the same time, or after the
     * first. Throws what either throws.
     */
    void runBoth(Runnable first, Runnable second);

    /** Called again and again while the second waits for the first. */
    void pause();
}
