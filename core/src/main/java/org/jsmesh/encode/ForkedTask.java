package org.jsmesh.encode;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.FutureTask;
import java.util.function.Supplier;

/**
 * Work that a helper does beside the caller; or the caller, who never waits for a helper that has not begun, when the
 * result is wanted.
 */
final class ForkedTask<T> {
    private final FutureTask<T> task;

    private ForkedTask(Supplier<T> work) {
        task = new FutureTask<>(work::get);
    }

    /** @param threads beyond the first one there are helpers */
    static <T> ForkedTask<T> start(Executor helpers, int threads, Supplier<T> work) {
        ForkedTask<T> beside = new ForkedTask<>(work);
        if (threads > 1) helpers.execute(beside.task);
        return beside;
    }

    T result() {
        task.run(); // nothing, when it has begun
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
