package org.jsmesh.encode.measure;

import java.util.function.Supplier;
import org.jsmesh.mesh.ProgressListener;

/**
 * Tells a listener which stage is under way while archives are written: coding, and the measuring and fitting that
 * interrupt it. So the times of the stages can be told apart.
 */
public final class StageProgress {
    private static final String CODING = "coding";

    private final ProgressListener listener;
    private double fraction;

    /** Begins with coding. */
    public StageProgress(ProgressListener listener) {
        this.listener = listener;
        coded(0);
    }

    /** Coding has come to a fraction of the whole, 0 to 1. */
    public void coded(double now) {
        fraction = now;
        listener.step(CODING, fraction);
    }

    /** Does some work of another stage; then coding goes on where it was. */
    public <T> T during(String stage, Supplier<T> work) {
        listener.step(stage, fraction);
        T result = work.get();
        listener.step(CODING, fraction);
        return result;
    }
}
