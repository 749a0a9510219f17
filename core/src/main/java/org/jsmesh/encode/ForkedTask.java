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
    private final Supplier<T> result;

    private ForkedTask(Supplier<T> result) {
        this.result = result;
    }

    /** @param threads in all; those beyond the first one are helpers */
    static <T> ForkedTask<T> start(Executor helpers, int threads, Supplier<T> work) {
        return threads > 1 ? fork(helpers, work) : new ForkedTask<>(new Once<>(work));
    }

    private static <T> ForkedTask<T> fork(Executor helpers, Supplier<T> work) {
        FutureTask<T> task = new FutureTask<>(work::get);
        helpers.execute(task);
        return new ForkedTask<>(() -> resultOf(task));
    }

    T result() {
        return result.get();
    }

    private static <T> T resultOf(FutureTask<T> task) {
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

    /** Work that the caller does when the result is wanted for the first time. */
    private static final class Once<T> implements Supplier<T> {
        private Supplier<T> work;
        private T value;

        Once(Supplier<T> work) {
            this.work = work;
        }

        @Override
        public T get() {
            if (work != null) value = work.get();
            work = null;
            return value;
        }
    }
}
