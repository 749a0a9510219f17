package org.jsmesh.encode;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.FutureTask;
import java.util.function.Supplier;

/**
 * Work that a helper does beside the caller. If no helper has begun when the caller wants the result, the caller does
 * the work itself.
 */
final class ForkedTask<T> {
    private final FutureTask<T> task;

    private ForkedTask(Supplier<T> work) {
        task = new FutureTask<>(work::get);
    }

    /** @param threads in all; those beyond the first one are helpers */
    static <T> ForkedTask<T> start(Executor helpers, int threads, Supplier<T> work) {
        ForkedTask<T> beside = new ForkedTask<>(work);
        if (threads > 1) helpers.execute(beside.task);
        return beside;
    }

    T result() {
        task.run(); // has no effect once it has begun
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    return task.get();
                } catch (InterruptedException e) {
                    interrupted = true;
                } catch (ExecutionException e) {
                    if (e.getCause() instanceof Error error) throw error;
                    if (e.getCause() instanceof RuntimeException failure) throw failure;
                    throw new IllegalStateException(e.getCause());
                }
            }
        } finally {
            if (interrupted) Thread.currentThread().interrupt();
        }
    }
}
