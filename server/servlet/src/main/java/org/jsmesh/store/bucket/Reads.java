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
 * Reads from a store on a few threads of its own, each read within a time, after which its thread is interrupted and
 * reads something else. Nobody waits for a store that does not answer: when all threads do, those who come are told so.
 * Thread-safe.
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
        Task<T> task = new Task<>(read);
        try {
            threads.execute(task);
        } catch (RejectedExecutionException e) {
            failed.incrementAndGet();
            return CompletableFuture.failedFuture(
                    ModelUnavailableException.passing("too many requests wait for the models' store", REMEDY, e));
        }
        CompletableFuture<T> timed = task.result.copy().orTimeout(mostMillis, TimeUnit.MILLISECONDS);
        return timed.exceptionally(failure -> {
            task.giveUp();
            throw explained(failure);
        });
    }

    /** A read that is given up when it takes too long. */
    private final class Task<T> implements Runnable {
        final CompletableFuture<T> result = new CompletableFuture<>();
        private final Read<T> read;
        private Thread reader; // null before and behind the read

        Task(Read<T> read) {
            this.read = read;
        }

        @Override
        public void run() {
            if (!begin()) return;
            T value = null;
            Throwable failure = null;
            try {
                value = read.run();
            } catch (Throwable e) {
                failure = e;
            }
            end();
            // One that was given up is counted by whoever did so.
            if (result.isDone()) return;
            (failure == null ? done : failed).incrementAndGet();
            if (failure == null) result.complete(value);
            else result.completeExceptionally(failure);
        }

        private synchronized boolean begin() {
            if (result.isDone()) return false;
            reader = Thread.currentThread();
            return true;
        }

        private synchronized void end() {
            reader = null;
            // What was meant for this read must not end the next one.
            Thread.interrupted();
        }

        /** Whoever has not begun need not any more. */
        synchronized void giveUp() {
            result.cancel(false);
            if (reader != null) reader.interrupt();
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
