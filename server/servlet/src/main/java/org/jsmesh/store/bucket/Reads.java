package org.jsmesh.store.bucket;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicLong;
import org.jsmesh.files.Explanation;
import org.jsmesh.store.ModelUnavailableException;

/**
 * Reads from a store on a few threads of its own, each read within a time. Nobody waits for a store that does not
 * answer: when all threads do, those who come are told so. Thread-safe.
 */
final class Reads implements AutoCloseable {
    private static final Logger LOG = System.getLogger(Reads.class.getName());
    private static final int THREADS = 32;
    private static final int MOST_WAITING = 1024;
    private static final int IDLE_SECONDS = 30;
    private static final long PAUSE_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final String REMEDY = "ask again later";

    private final String address;
    private final long mostMillis;
    private final ThreadPoolExecutor threads;
    private final AtomicLong done = new AtomicLong();
    private final AtomicLong failed = new AtomicLong();
    private final AtomicLong warnedNanos = new AtomicLong();

    /** Reads something. */
    interface Read<T> {
        T run() throws IOException;
    }

    /**
     * @param address of the store, for people
     * @param mostMillis that a read may take, with the wait for a thread
     */
    Reads(String address, long mostMillis) {
        this.address = address;
        this.mostMillis = mostMillis;
        threads = new ThreadPoolExecutor(
                THREADS, THREADS, IDLE_SECONDS, TimeUnit.SECONDS, new LinkedBlockingQueue<>(MOST_WAITING), task -> {
                    Thread thread = new Thread(task, "jsm-objects");
                    thread.setDaemon(true);
                    return thread;
                });
        threads.allowCoreThreadTimeOut(true);
    }

    /** {@return completes exceptionally with a {@link ModelUnavailableException} alone} */
    <T> CompletableFuture<T> begin(Read<T> read) {
        CompletableFuture<T> result = new CompletableFuture<>();
        try {
            threads.execute(() -> run(read, result));
        } catch (RejectedExecutionException e) {
            failed.incrementAndGet();
            return CompletableFuture.failedFuture(
                    ModelUnavailableException.passing("too many requests wait for the models' store", REMEDY, e));
        }
        CompletableFuture<T> timed = result.copy().orTimeout(mostMillis, TimeUnit.MILLISECONDS);
        return timed.exceptionally(failure -> {
            // Whoever has not begun need not any more.
            result.cancel(false);
            throw explained(failure);
        });
    }

    private <T> void run(Read<T> read, CompletableFuture<T> result) {
        if (result.isDone()) return;
        try {
            T value = read.run();
            done.incrementAndGet();
            result.complete(value);
        } catch (Throwable e) {
            failed.incrementAndGet();
            result.completeExceptionally(e);
        }
    }

    private CompletionException explained(Throwable failure) {
        Throwable cause = failure;
        while (cause instanceof CompletionException && cause.getCause() != null) cause = cause.getCause();
        if (cause instanceof ModelUnavailableException) return new CompletionException(cause);
        String reason;
        if (cause instanceof TimeoutException) {
            failed.incrementAndGet();
            reason = "the models' store did not answer within " + mostMillis + " ms";
            warn(address + ": no answer within " + mostMillis + " ms");
        } else {
            reason = "the models' store cannot be read at the moment";
            String why =
                    cause instanceof IOException e ? Explanation.of(address, e).toString() : address + ": " + cause;
            warn("Cannot read from the store. " + why);
        }
        return new CompletionException(ModelUnavailableException.passing(reason, REMEDY, cause));
    }

    /** A store that is down would fill the log. */
    private void warn(String what) {
        long now = System.nanoTime();
        long last = warnedNanos.get();
        if (last != 0 && now - last < PAUSE_NANOS || !warnedNanos.compareAndSet(last, now)) return;
        LOG.log(Level.WARNING, what);
    }

    /** Reads that have succeeded since the start. */
    long done() {
        return done.get();
    }

    /** Reads that have failed or were given up. */
    long failed() {
        return failed.get();
    }

    /** Reads that wait for a thread. */
    int waiting() {
        return threads.getQueue().size();
    }

    /** Interrupts what is being read. */
    @Override
    public void close() {
        threads.shutdownNow();
    }
}
