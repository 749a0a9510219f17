package org.jsmesh.desktop;

import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.jsmesh.desktop.chart.LoadRecord;
import org.jsmesh.session.SessionProgress;

/**
 * Notes how far a session is while its calls are under way, on a thread of its own, so that drawing does not delay it.
 * Thread-safe.
 */
final class LoadSampler implements AutoCloseable {
    private static final int PACE_MILLIS = 100;

    private final LoadRecord load = new LoadRecord();
    private final Supplier<SessionProgress> progress;
    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(task -> {
        Thread thread = new Thread(task, "jsm-chart");
        thread.setDaemon(true);
        return thread;
    });
    private int calls;

    /** @param progress of the session, now */
    LoadSampler(Supplier<SessionProgress> progress) {
        this.progress = progress;
        clock.scheduleAtFixedRate(this::tick, PACE_MILLIS, PACE_MILLIS, TimeUnit.MILLISECONDS);
    }

    LoadRecord load() {
        return load;
    }

    /** A call begins. */
    synchronized void begin() {
        if (calls == 0) sample(true);
        calls++;
    }

    /** A call has ended. */
    synchronized void end() {
        calls--;
        sample(calls > 0);
    }

    private synchronized void tick() {
        if (calls > 0) sample(true);
    }

    private void sample(boolean loading) {
        SessionProgress now = progress.get();
        load.sample(System.nanoTime() / 1_000_000, loading, now.bytes(), now.faces(), now.errorMean());
    }

    @Override
    public void close() {
        clock.shutdownNow();
    }
}
