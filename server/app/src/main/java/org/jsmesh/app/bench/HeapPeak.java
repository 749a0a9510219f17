package org.jsmesh.app.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryMXBean;

/**
 * Measures the most heap that a piece of work holds. It samples by collecting garbage again and again beside the work,
 * so it measures what the work needs and not the garbage that it leaves.
 */
final class HeapPeak {
    private static final int PAUSE_MILLIS = 5;
    private static final MemoryMXBean MEMORY = ManagementFactory.getMemoryMXBean();

    private HeapPeak() {}

    /** Work that may fail. */
    interface Work {
        void run() throws IOException;
    }

    /** @return bytes in use at the peak, including what lived before */
    static long of(Work work) throws IOException {
        Sampler sampler = new Sampler();
        sampler.start();
        try {
            work.run();
        } finally {
            sampler.stopped = true;
            join(sampler);
        }
        return sampler.peak;
    }

    private static void join(Thread thread) {
        try {
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static final class Sampler extends Thread {
        volatile boolean stopped;
        long peak;

        Sampler() {
            super("heap-sampler");
            setDaemon(true);
        }

        @Override
        public void run() {
            do {
                MEMORY.gc();
                peak = Math.max(peak, MEMORY.getHeapMemoryUsage().getUsed());
                try {
                    Thread.sleep(PAUSE_MILLIS);
                } catch (InterruptedException e) {
                    return;
                }
            } while (!stopped);
        }
    }
}
