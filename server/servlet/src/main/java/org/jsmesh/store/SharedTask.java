package org.jsmesh.store;

import java.io.IOException;
import java.util.concurrent.atomic.AtomicLong;

/**
 * A task whose effect many callers want at once. It runs once at a time. A caller that came before a run began need not
 * run it again. So each caller waits for two runs at most, however many come together. Thread-safe.
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
     * @throws IOException when the run fails that the caller began; other callers then begin one of their own
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
