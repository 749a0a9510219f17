package org.jsmesh.session;

import java.io.IOException;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.plan.BatchRequest;
import org.jsmesh.plan.RoundPlanner;
import org.jsmesh.session.cache.DiskCache;
import org.jsmesh.session.cache.KeptArchive;

/**
 * The network side of a session: asks, reads, resumes. Runs on the session's thread alone.
 *
 * <p>It does not repair a connection that breaks. The next request begins at the byte where the connection stopped. So
 * no byte is sent twice, and the planner decides again what still fits into the round.
 */
final class SessionEngine {
    /** Precision of a deadline. */
    private static final long POLL_MILLIS = 5;

    private final ArchiveSource source;
    private final ReceivedArchive archive;
    private final SessionOptions options;
    private final SteadyClock clock;
    private final TraceRecorder trace;
    private final Runnable arrived;
    private final RoundPlanner planner = new RoundPlanner();
    private final Retries retries;
    private BooleanSupplier cancelled = () -> false;
    private RangeDownload active;
    private boolean restored;
    private boolean paused;
    private double shownMillis;

    /**
     * @param arrived called after every portion of bytes
     * @param pausing hears of pauses after failures
     */
    SessionEngine(
            ArchiveSource source,
            ReceivedArchive archive,
            SessionOptions options,
            SteadyClock clock,
            TraceRecorder trace,
            Runnable arrived,
            Retries.Pausing pausing) {
        this.source = source;
        this.archive = archive;
        this.options = options;
        this.clock = clock;
        this.trace = trace;
        this.arrived = arrived;
        retries = new Retries(source, archive, options, clock, pausing);
    }

    /** The estimate, 0 for a local file. */
    double bytesPerSecond() {
        return source.isLocal() ? 0 : planner.bytesPerSecond(clock.millis());
    }

    /**
     * One round.
     *
     * @param calledMillis when the user asked for it
     * @param ended called once, when the result should be shown; the response then goes on, see {@link #settle}
     */
    void refine(double calledMillis, int waitMillis, BooleanSupplier isCancelled, Consumer<RoundReport> ended)
            throws IOException {
        begin(isCancelled);
        if (options.cache() != null) locate();
        double startMillis = Math.max(calledMillis, shownMillis); // calls that queue up wait one after the other
        planner.beginRound(startMillis, waitMillis);
        trace.beginRound(startMillis, waitMillis, archive.bytes());
        if (active != null) trace.planned(archive.bytes() + active.bytesLeft());
        while (true) {
            if (active == null) {
                BatchRequest request = nextRequest();
                if (request == null) break;
                ask(request);
            }
            if (!read(() -> planner.isOver(clock.millis(), isBasePresent()))) break;
        }
        endRound(ended);
        if (active != null && source.isLocal()) finish(true);
    }

    /** Fetches everything that is left, in one request per connection. */
    void complete(double calledMillis, BooleanSupplier isCancelled, Consumer<RoundReport> ended) throws IOException {
        begin(isCancelled);
        if (options.cache() != null) locate();
        long left = archive.index() == null ? 0 : archive.index().archiveBytes() - archive.bytes();
        double rate = bytesPerSecond();
        trace.beginRound(
                Math.max(calledMillis, shownMillis), rate > 0 ? (long) (left * 1000 / rate) : 0, archive.bytes());
        while (!archive.isComplete()) {
            if (active == null) {
                retries.pause(Double.MAX_VALUE, cancelled);
                locate();
                begin(source.open(archive.bytes(), -1, archive.entityTag()));
            }
            read(() -> false);
            if (archive.index() != null) trace.planned(archive.index().archiveBytes());
        }
        endRound(ended);
        if (active != null) finish(false);
    }

    private void endRound(Consumer<RoundReport> ended) {
        shownMillis = clock.millis();
        if (active != null) trace.underWay(active.report());
        ended.accept(trace.endRound(shownMillis, archive, bytesPerSecond()));
    }

    /** Ends the pause before the next attempt. On any thread. */
    void tryNow() {
        retries.tryNow();
    }

    /** Gives up the response under way. */
    void close() {
        if (active != null) finish(true);
        archive.close();
    }

    private void begin(BooleanSupplier isCancelled) {
        cancelled = isCancelled;
        retries.reset();
        if (paused) active.resumed();
        paused = false;
    }

    private void begin(ArchiveBody body) {
        active = new RangeDownload(body, archive, planner, clock);
    }

    private boolean isBasePresent() {
        return archive.batches() > 0;
    }

    /** The known index: the archive's own, or what the manifest promises. */
    private BatchIndex index() {
        return archive.index() != null || archive.bytes() > 0 ? archive.index() : source.promisedIndex();
    }

    private BatchRequest nextRequest() throws IOException {
        if (archive.isComplete()) return null;
        if (!retries.pause(isBasePresent() ? planner.deadlineMillis() : Double.MAX_VALUE, cancelled)) return null;
        locate();
        return planner.next(clock.millis(), index(), archive.bytes());
    }

    private void locate() throws IOException {
        while (true) {
            try {
                source.locate(cancelled);
                restore();
                return;
            } catch (IOException e) {
                failed(e);
                retries.pause(Double.MAX_VALUE, cancelled);
            }
        }
    }

    /** Takes what earlier sessions have kept, once, before anything is asked for. */
    private void restore() throws IOException {
        boolean known = source.address() != null && source.archiveSha256() != null;
        if (restored || !known || options.cache() == null || archive.bytes() > 0) return;
        restored = true;
        KeptArchive kept;
        try {
            kept = new DiskCache(options.cache(), options.cacheBytes()).open(source.address(), source.archiveSha256());
        } catch (IOException e) {
            return; // a folder that cannot be used keeps nothing
        }
        archive.restore(kept);
        if (archive.bytes() > 0) arrived.run();
    }

    private void ask(BatchRequest request) {
        BatchIndex index = archive.index();
        long endByte = request.endByte();
        ArchiveBody body;
        if (source.isLocal()) {
            body = source.open(request.fromByte(), -1, archive.entityTag());
        } else if (!source.isPlanning() || index == null) {
            body = source.open(request.fromByte(), endByte, archive.entityTag());
        } else if (request.fromBatch() > 0 && request.fromByte() == index.offset(request.fromBatch())) {
            body = source.openPlanned(request);
        } else {
            // The server plans whole batches, so a range ends a batch that has begun.
            endByte = index.end(request.fromBatch());
            body = source.open(request.fromByte(), endByte, archive.entityTag());
        }
        trace.planned(endByte);
        begin(body);
    }

    /**
     * Reads until the answer ended or broke; then there is no active answer and it returns true. Or reads until it is
     * time to stop and returns false.
     */
    private boolean read(BooleanSupplier isTime) throws IOException {
        try {
            while (!active.isEnded()) {
                if (cancelled.getAsBoolean()) throw new CancellationException("cancelled");
                if (isTime.getAsBoolean()) return false;
                long before = archive.bytes();
                if (!active.step(POLL_MILLIS) && active.silentMillis() > options.stallMillis()) {
                    throw new IOException("nothing came for " + options.stallMillis() + " ms");
                }
                if (archive.bytes() > before) {
                    retries.reset();
                    arrived.run();
                }
            }
            finish(false);
        } catch (CancellationException e) {
            finish(true);
            throw e;
        } catch (IOException e) {
            finish(true);
            failed(e);
        }
        return true;
    }

    private void finish(boolean broken) {
        RangeDownload transfer = active;
        active = null;
        paused = false;
        if (broken) transfer.cancel();
        planner.ended(source.isLocal());
        trace.request(transfer.report());
    }

    /**
     * Between two calls: reads the response under way on for a while, as the planner says, and then gives it up. A body
     * that is the whole archive waits for the next call instead.
     *
     * @param isAwaited tells whether the next call has come; that call goes on with the response under way
     */
    void settle(BooleanSupplier isAwaited) throws IOException {
        if (active == null || paused || isAwaited.getAsBoolean()) return;
        if (!active.isRanged()) {
            paused = true;
            planner.ended(false);
            return;
        }
        BooleanSupplier isOver = () -> !planner.mayGoOn(clock.millis(), active.bytesLeft());
        boolean ended = read(() -> isAwaited.getAsBoolean() || isOver.getAsBoolean());
        if (!ended && !isAwaited.getAsBoolean()) finish(true);
    }

    private void failed(IOException error) throws IOException {
        if (error instanceof FetchException fetch && fetch.isGone() && isRenewed()) return;
        retries.failed(error);
    }

    /** Whether there is another archive by now; nothing of it has been fetched. */
    private boolean isRenewed() throws IOException {
        boolean renewed;
        try {
            renewed = source.isRenewed(cancelled);
        } catch (IOException e) {
            return false; // the first failure tells more
        }
        if (renewed && archive.bytes() > 0)
            throw new ArchiveChangedException(source.name(), "its manifest names another one by now");
        if (renewed) {
            archive.close();
            restored = false;
        }
        return renewed;
    }
}
