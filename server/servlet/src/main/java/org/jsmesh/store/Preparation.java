package org.jsmesh.store;

import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import org.jsmesh.mesh.ProgressListener;

/**
 * One attempt at making a model's archive ready, shared by everybody who waits for it, and then what came of it. Its
 * listener passes the encoder's progress on to the catalogue and cancels the encoding when nobody can need it any more.
 */
final class Preparation implements ProgressListener {
    /** The stage before it is known whether the model must be encoded. */
    static final String OPENING = "opening";

    private static final long RECENT_NANOS = 100_000_000L;
    private static final long RACY_NANOS = 1_000_000_000L;
    private static final CompletableFuture<Archive> AT_REST = new CompletableFuture<>();

    private final ModelEntry entry;
    private volatile CompletableFuture<Archive> archive = new CompletableFuture<>();
    private final Pause pause;
    private final Wish wish;
    private volatile SourceStamp stamp;
    private volatile Set<Path> witnesses = Set.of();
    private volatile ArchiveFacts facts;
    private volatile String stage = OPENING;
    private StateCounts.Counted counted;
    private volatile double fraction;
    private volatile boolean cancelled;
    private volatile long seenNanos = System.nanoTime();
    private volatile long stampedNanos = seenNanos;

    /** @param before what is known of the model since an earlier attempt, or null */
    Preparation(ModelEntry entry, SourceStamp stamp, Wish wish, Preparation before) {
        this.entry = entry;
        this.stamp = stamp;
        this.wish = wish;
        boolean isSame = before != null && before.isOf(entry) && before.isUnchanged(stamp);
        pause = isSame ? before.pause.next() : new Pause();
        if (before != null && before.isOf(entry)) {
            // A model whose archive was closed meanwhile is as ready as before.
            if (isSame) facts = before.facts;
            witnesses = before.witnesses;
        }
    }

    /** Counts the preparation until somebody ends that. */
    void countIn(StateCounts.Counted in) {
        counted = in;
        if (facts != null) in.become(ModelStatus.State.READY);
        archive.whenComplete(
                (done, failure) -> in.become(failure == null ? ModelStatus.State.READY : ModelStatus.State.FAILED));
    }

    StateCounts.Counted counted() {
        return counted;
    }

    ModelEntry entry() {
        return entry;
    }

    Wish wish() {
        return wish;
    }

    CompletableFuture<Archive> archive() {
        return archive;
    }

    SourceStamp stamp() {
        return stamp;
    }

    /** Files beside the model that decide whether it has changed. */
    Set<Path> witnesses() {
        return witnesses;
    }

    /** What a catalogue tells; null while there is no archive. */
    ArchiveFacts facts() {
        return facts;
    }

    private boolean isOf(ModelEntry now) {
        return entry == now || entry.place().equals(now.place());
    }

    private boolean isUnchanged(SourceStamp now) {
        return stamp.isSame(now);
    }

    /** Whether the list of models speaks of the file as this attempt found it. */
    boolean isListed(ModelEntry now) {
        return isOf(now) && entry.bytes() == now.bytes() && entry.modified().equals(now.modified());
    }

    /**
     * Whether the result is valid for the file as it is now. A failure is valid for a while, because its cause may lie
     * outside the file. So is what was read just after a change, which may have been in the middle of changes.
     */
    boolean isGoodFor(ModelEntry now, SourceStamp stampNow) {
        CompletableFuture<Archive> result = archive;
        if (result == AT_REST || !isOf(now) || !isUnchanged(stampNow)) return false;
        if (!result.isDone()) return true;
        if (result.isCompletedExceptionally()) return pause.isOn();
        if (stamp.isFresh() && System.nanoTime() - stampedNanos > RACY_NANOS) return false;
        return open() != null;
    }

    /** The archive that can be read now, or null. */
    Archive open() {
        CompletableFuture<Archive> result = archive;
        Archive open = result.isCompletedExceptionally() ? null : result.getNow(null);
        return open == null || open.isBroken() || open.isClosed() ? null : open;
    }

    /** Closes the archive and keeps only what a catalogue tells of it. */
    void rest() {
        CompletableFuture<Archive> result = archive;
        archive = AT_REST;
        result.thenAccept(Archive::close);
    }

    /** Nobody needs it any more. */
    void dispose() {
        cancelled = true;
        archive.thenAccept(Archive::close);
    }

    /** The file was found to be the same just now. */
    Preparation seen() {
        seenNanos = System.nanoTime();
        return this;
    }

    /** Whether the file was looked at a moment ago. */
    boolean isRecent(ModelEntry now) {
        return System.nanoTime() - seenNanos < RECENT_NANOS && isOf(now);
    }

    /** What was read besides the model file. */
    void witnessed(Set<Path> paths, SourceStamp with) {
        witnesses = Set.copyOf(paths);
        stamp = with;
    }

    /** The archive is there. */
    void complete(Archive ready) {
        facts = ArchiveFacts.of(ready);
        pause.reset();
        archive.complete(ready);
    }

    void fail(ModelUnavailableException reason) {
        facts = null;
        pause.begin(reason.isPassing());
        archive.completeExceptionally(reason.retriedIn(pause.seconds()));
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
