package org.jsmesh.encode;

import java.util.concurrent.Executor;
import java.util.concurrent.locks.LockSupport;
import org.jsmesh.codec.connectivity.PairRunner;

/** Runs two halves of work in two threads: the calling one, and a helper when one is free. */
final class ForkedPairRunner implements PairRunner {
    private static final int SPINS = 200; // before the processor is left to others
    private static final long NAP_NANOS = 20_000;

    private final Executor helpers;
    private int spins; // of the second half

    ForkedPairRunner(Executor helpers) {
        this.helpers = helpers;
    }

    @Override
    public void runBoth(Runnable first, Runnable second) {
        ForkedTask<Void> beside = ForkedTask.start(helpers, 2, () -> {
            second.run();
            return null;
        });
        first.run();
        beside.result();
    }

    @Override
    public void pause() {
        if (++spins % SPINS == 0) LockSupport.parkNanos(NAP_NANOS);
        else Thread.onSpinWait();
    }
}
