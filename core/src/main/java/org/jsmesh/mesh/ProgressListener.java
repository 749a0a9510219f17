package org.jsmesh.mesh;

import java.util.concurrent.CancellationException;

/** Hears how far a long operation is, and may stop it. Called often, from one thread at a time. */
public interface ProgressListener {
    ProgressListener NONE = (stage, fraction) -> {};

    /**
     * @param stage what is being done, a few words
     * @param fraction of this stage, 0 to 1
     */
    void progress(String stage, double fraction);

    /** True to give the operation up. It then throws {@link CancellationException} and leaves nothing behind. */
    default boolean isCancelled() {
        return false;
    }

    /** Reports and stops in one call. */
    default void step(String stage, double fraction) {
        if (isCancelled()) throw new CancellationException(stage + " was cancelled");
        progress(stage, fraction);
    }
}
