package org.jsmesh.store;

import java.io.IOException;
import java.util.concurrent.atomic.AtomicLong;

/**
 * A task of which many want the effect at once. It runs once at a time, and whoever has come before a run began need
 * not run it again: however many come together, each waits for two runs at most. Thread-safe.
 */
final class SharedTask {
    /** What is to be done. */
    interface Task {
        void run() throws IOException;
    }

    private final Task task;
    private final Object running = new Object();
    private final AtomicLong begun = new AtomicLong();
    private long done;

    SharedTask(Task task) {
        this.task = task;
    }

    /**
     * Returns after a run that began after the call.
     *
     * @throws IOException when the run fails that the caller began; others begin one of their own then
     */
    void run() throws IOException {
        long wanted = begun.get() + 1;
        synchronized (running) {
            if (done >= wanted) return;
            long number = begun.incrementAndGet();
            task.run();
            done = number;
        }
    }
}
