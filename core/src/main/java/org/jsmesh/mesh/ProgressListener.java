package org.jsmesh.mesh;

import java.util.concurrent.CancellationException;

/** Hears how far a long operation is, and may stop it. Called often, from one thread at a time. */
public interface ProgressListener {
    /** Hears nothing and stops nothing. */
    ProgressListener NONE = (stage, fraction) -> {};

    /**
     * Hears how far the operation is.
     *
     * @param stage what is being done, a few words
     * @param fraction of this stage, 0 to 1
     */
    void progress(String stage, double fraction);

    /**
     * Tells whether to give the operation up. It then throws {@link CancellationException} and leaves nothing behind.
     *
     * @return true to give it up; a listener that does not say never does
     */
    default boolean isCancelled() {
        return false;
    }

    /**
     * Reports and stops in one call.
     *
     * @param stage what is being done, a few words
     * @param fraction of this stage, 0 to 1
     * @throws CancellationException when the operation is to be given up
     */
    default void step(String stage, double fraction) {
        if (isCancelled()) throw new CancellationException(stage + " was cancelled");
        progress(stage, fraction);
    }
}
