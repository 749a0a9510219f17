package org.jsmesh.store;

import java.util.concurrent.CompletableFuture;
import org.jsmesh.mesh.ProgressListener;

/**
 * One attempt at making a model's archive ready: shared by everybody who waits for it. Its listener passes the
 * encoder's progress on to the catalogue and cancels the encoding when nobody can need it any more.
 */
final class Preparation implements ProgressListener {
    private static final long FAILURE_KEPT_NANOS = 60_000_000_000L;
    private static final long RECENT_NANOS = 100_000_000L;

    private final ModelEntry entry;
    private final SourceStamp stamp;
    private final CompletableFuture<Archive> archive = new CompletableFuture<>();
    private volatile String stage = "waiting";
    private volatile double fraction;
    private volatile boolean cancelled;
    private volatile long failedNanos;
    private volatile long seenNanos = System.nanoTime();

    Preparation(ModelEntry entry, SourceStamp stamp) {
        this.entry = entry;
        this.stamp = stamp;
    }

    ModelEntry entry() {
        return entry;
    }

    SourceStamp stamp() {
        return stamp;
    }

    CompletableFuture<Archive> archive() {
        return archive;
    }

    /**
     * Whether the result is valid for the file as it is now. A failure is valid for a minute, because its cause may lie
     * outside the file.
     */
    boolean isGoodFor(ModelEntry now, SourceStamp stampNow) {
        if (!entry.path().equals(now.path()) || !stamp.equals(stampNow)) return false;
        return !archive.isCompletedExceptionally() || System.nanoTime() - failedNanos < FAILURE_KEPT_NANOS;
    }

    /** The file was found to be the same just now. */
    Preparation seen() {
        seenNanos = System.nanoTime();
        return this;
    }

    /** Whether the file was looked at a moment ago. */
    boolean isRecent(ModelEntry now) {
        return System.nanoTime() - seenNanos < RECENT_NANOS && entry.path().equals(now.path());
    }

    void fail(ModelUnavailableException reason) {
        failedNanos = System.nanoTime();
        archive.completeExceptionally(reason);
    }

    void cancel() {
        cancelled = true;
    }

    @Override
    public boolean isCancelled() {
        return cancelled;
    }

    @Override
    public void progress(String stageNow, double fractionNow) {
        stage = stageNow;
        fraction = fractionNow;
    }

    /** What is being done, a few words. */
    String stage() {
        return stage;
    }

    double fraction() {
        return fraction;
    }
}
