package org.jsmesh.codec.connectivity;

/** Does half of an encoder's work beside it. */
public interface PairRunner {
    /**
     * Runs both, the second perhaps by a helper at the same time, perhaps after the first, and returns when they are
     * done; throws what either throws.
     */
    void runBoth(Runnable first, Runnable second);

    /** Called again and again while the second waits for the first. */
    void pause();
}
