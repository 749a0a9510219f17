package org.jsmesh.collapse;

import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Cuts ranges of work into pieces that the calling thread and helpers from an executor take in turn. The caller never
 * waits for a helper that has not begun.
 */
final class RangeRunner {
    /** Work on the elements from..to − 1 by worker 0 (the caller), 1, 2, … */
    interface Work {
        void run(int worker, int from, int to);
    }

    private static final int PIECE = 1024;

    private final Executor executor;
    private final int workers;

    RangeRunner(Executor executor, int workers) {
        if (workers < 1) throw new IllegalArgumentException(workers + " threads");
        this.executor = executor;
        this.workers = workers;
    }

    int workers() {
        return workers;
    }

    void run(int size, Work work) {
        int pieces = (size + PIECE - 1) / PIECE;
        if (workers == 1 || pieces < 2) {
            work.run(0, 0, size);
            return;
        }
        Job job = new Job(size, pieces, work);
        for (int worker = 1; worker < Math.min(workers, pieces); worker++) {
            int id = worker;
            executor.execute(() -> job.take(id));
        }
        job.take(0);
        job.await();
    }

    private static final class Job {
        private final int size;
        private final int pieces;
        private final Work work;
        private final AtomicInteger next = new AtomicInteger();
        private int finished;
        private RuntimeException failure;

        Job(int size, int pieces, Work work) {
            this.size = size;
            this.pieces = pieces;
            this.work = work;
        }

        void take(int worker) {
            for (int piece = next.getAndIncrement(); piece < pieces; piece = next.getAndIncrement()) {
                RuntimeException thrown = null;
                try {
                    work.run(worker, piece * PIECE, Math.min(size, (piece + 1) * PIECE));
                } catch (RuntimeException e) {
                    thrown = e;
                }
                finish(thrown);
            }
        }

        private synchronized void finish(RuntimeException thrown) {
            if (failure == null) failure = thrown;
            if (++finished == pieces) notifyAll();
        }

        synchronized void await() {
            boolean interrupted = false;
            while (finished < pieces) {
                try {
                    wait();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
            if (interrupted) Thread.currentThread().interrupt();
            if (failure != null) throw failure;
        }
    }
}
