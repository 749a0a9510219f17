package org.jsmesh.session;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;

/**
 * Streams one archive (section 5.2 of Chen and Nishita 2002). Every {@link #refine} costs the same wait and shows as
 * much more of the model as the bandwidth affords. {@link #complete} brings the original and proves it. Nothing is
 * fetched twice. When a connection breaks, the session resumes at the byte where it stopped. The description of the
 * package has an example.
 *
 * <p>Thread-safe. Calls queue up. The network and the decoder run on the session's own thread, the listener on the
 * given executor. Futures complete on the session's thread, so attach long work with the {@code Async} methods. They
 * fail with {@link MalformedStreamException}, {@link ArchiveChangedException}, {@link FetchException} or another
 * {@link IOException}, each with a message for the user. After the first two, and after a lasting
 * {@code FetchException}, every further call fails the same way.
 */
public final class StreamingSession implements AutoCloseable {
    private final SteadyClock clock = new SteadyClock();
    private final TraceRecorder trace = new TraceRecorder();
    private final ExecutorService network;
    private final AtomicInteger cancellations = new AtomicInteger();
    /** Calls that have not begun. */
    private final AtomicInteger queued = new AtomicInteger();

    private final ArchiveSource source;
    private final ReceivedArchive archive;
    private final SessionEngine engine;
    private final ListenerFeed feed;
    private final MeshFeed meshes;
    private volatile SessionProgress progress = new SessionProgress(0, -1, 0, -1, 0, -1, 0, 0, 0);
    private volatile ArchiveHeader header;
    private volatile SessionResult result;
    private volatile boolean closed;
    private volatile Thread thread;
    private IOException over;

    private StreamingSession(
            URI location,
            Path file,
            SessionOptions options,
            MeshStream stream,
            SessionListener listener,
            Executor listenerExecutor) {
        feed = new ListenerFeed(listener, listenerExecutor);
        source = file != null
                ? new FileSource(file, clock)
                : new HttpSource(location, options, clock, trace::request, feed::preparing);
        archive = new ReceivedArchive(source.name(), stream, options.arrived());
        LiveFollower follower = listener.isLive() ? stream.follow() : null;
        meshes = new MeshFeed(archive, feed, follower, clock, options.meshMillis());
        engine = new SessionEngine(source, archive, options, clock, trace, this::arrived, feed::retrying);
        network = Executors.newSingleThreadExecutor(task -> {
            thread = new Thread(task, "jsm-session");
            thread.setDaemon(true);
            return thread;
        });
    }

    /**
     * Prepares a session; nothing is fetched before the first call.
     *
     * @param location http or https address of an archive, or of a manifest (its path ends with .json, or the server
     *     says so); or file address of an archive
     * @param options how the session behaves
     * @param listener hears of the session
     * @param listenerExecutor on which the listener is called: one thread, such as the event queue of a window
     * @return the session, to be closed by the caller
     * @throws IllegalArgumentException for other addresses
     */
    public static StreamingSession open(
            URI location, SessionOptions options, SessionListener listener, Executor listenerExecutor) {
        return open(location, options, new DecodedArchive(), listener, listenerExecutor);
    }

    /**
     * {@return a session over a local file, to be closed by the caller; it has the same rounds, at the speed of the
     * disk}
     *
     * @param file an archive; a missing one makes the first call fail
     * @param options how the session behaves; server plan and HTTP/2 mean nothing to a file
     * @param listener hears of the session
     * @param listenerExecutor on which the listener is called: one thread, such as the event queue of a window
     */
    public static StreamingSession open(
            Path file, SessionOptions options, SessionListener listener, Executor listenerExecutor) {
        return new StreamingSession(null, file, options, new DecodedArchive(), listener, listenerExecutor);
    }

    static StreamingSession open(
            URI location,
            SessionOptions options,
            MeshStream stream,
            SessionListener listener,
            Executor listenerExecutor) {
        String scheme = String.valueOf(location.getScheme());
        if (scheme.equals("file"))
            return new StreamingSession(null, FileSource.path(location), options, stream, listener, listenerExecutor);
        if (!scheme.equals("http") && !scheme.equals("https") || location.getHost() == null) {
            throw new IllegalArgumentException(location + " is no http, https or file address");
        }
        if (location.getPort() > 65535)
            throw new IllegalArgumentException(location + ": port " + location.getPort() + " is above 65535");
        return new StreamingSession(location, null, options, stream, listener, listenerExecutor);
    }

    /**
     * Runs one round: waits at most {@code waitMillis}, and longer only while the base mesh has not arrived; then shows
     * what is there. The first call also opens the archive.
     *
     * @param waitMillis the time T that the user waits
     * @return what the round brought; at the end of the archive a round of 0 bytes at once
     */
    public CompletableFuture<RoundReport> refine(int waitMillis) {
        if (waitMillis <= 0) throw new IllegalArgumentException("wait in milliseconds: " + waitMillis);
        CompletableFuture<RoundReport> future = new CompletableFuture<>();
        double called = clock.millis();
        submit(future, cancelled -> {
            engine.refine(called, waitMillis, cancelled, round -> roundEnded(round, future));
        });
        return future;
    }

    /**
     * Fetches all that is left and compares the hashes.
     *
     * @return the mesh; {@link SessionResult#identical()} says whether it is the original
     */
    public CompletableFuture<SessionResult> complete() {
        CompletableFuture<SessionResult> future = new CompletableFuture<>();
        double called = clock.millis();
        submit(future, cancelled -> {
            if (result == null)
                engine.complete(called, cancelled, round -> roundEnded(round, new CompletableFuture<>()));
            verify();
            future.complete(result);
        });
        return future;
    }

    /**
     * Gives up the calls under way: their futures end with {@link CancellationException}. What has arrived is kept, and
     * the session can go on.
     */
    public void cancel() {
        cancellations.incrementAndGet();
    }

    /** Ends the pause before the next attempt, see {@link SessionListener#retrying}; does nothing at other times. */
    public void tryNow() {
        engine.tryNow();
    }

    /** {@return the mesh as it is when the calls before have ended, or null when the base has not arrived} */
    public CompletableFuture<Mesh> snapshot() {
        CompletableFuture<Mesh> future = new CompletableFuture<>();
        submit(future, cancelled -> future.complete(archive.batches() == 0 ? null : archive.mesh()));
        return future;
    }

    /** Gives everything up, ends the session's thread and waits shortly for it. The trace is complete then. */
    @Override
    public void close() {
        closed = true;
        cancel();
        try {
            network.execute(engine::close);
        } catch (RejectedExecutionException e) {
            return; // closed before
        }
        network.shutdown();
        if (Thread.currentThread() == thread) return;
        try {
            network.awaitTermination(2, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** {@return how far the session is now} */
    public SessionProgress progress() {
        return progress;
    }

    /** {@return what the archive says of itself, or null until it has arrived} */
    public ArchiveHeader header() {
        return header;
    }

    /** {@return the proof at the end, or null until everything has arrived} */
    public SessionResult result() {
        return result;
    }

    /** {@return rounds and requests so far; a request under way has what had arrived when the last round ended} */
    public SessionTrace trace() {
        return trace.snapshot();
    }

    private interface Job {
        void run(BooleanSupplier cancelled) throws IOException;
    }

    private void submit(CompletableFuture<?> future, Job job) {
        int generation = cancellations.get();
        if (closed) throw new IllegalStateException("the session is closed");
        queued.incrementAndGet();
        execute(() -> {
            queued.decrementAndGet();
            try {
                if (over != null) throw over;
                if (generation != cancellations.get()) throw new CancellationException("cancelled");
                job.run(() -> generation != cancellations.get());
                engine.settle(() -> queued.get() > 0);
                verify();
            } catch (CancellationException e) {
                future.completeExceptionally(e);
            } catch (IOException e) {
                boolean lasting = e instanceof FetchException fetch && fetch.isLasting();
                if (lasting || e instanceof MalformedStreamException || e instanceof ArchiveChangedException) over = e;
                // The batches before a damaged one are good, but nobody has heard of them yet.
                arrived();
                meshes.show(progress);
                feed.call(listener -> listener.failed(e));
                future.completeExceptionally(e);
            } catch (RuntimeException | Error e) {
                // Whoever waits hears of it; the thread goes on.
                future.completeExceptionally(e);
            }
        });
    }

    private void execute(Runnable task) {
        try {
            network.execute(task);
        } catch (RejectedExecutionException e) {
            throw new IllegalStateException("the session is closed", e);
        }
    }

    /** On the session's thread, after each portion of bytes. */
    private void arrived() {
        if (header == null && archive.header() != null) {
            header = archive.header();
            ArchiveHeader h = header;
            feed.call(listener -> listener.opened(h));
        }
        updateProgress();
        feed.progressed(progress);
        meshes.arrived(progress);
    }

    private void updateProgress() {
        progress = SessionProgress.of(archive, engine.bytesPerSecond());
    }

    private void roundEnded(RoundReport round, CompletableFuture<RoundReport> future) {
        updateProgress();
        meshes.show(progress);
        feed.progressed(progress);
        feed.call(listener -> listener.roundEnded(round));
        future.complete(round);
    }

    private void verify() throws IOException {
        if (result != null || !archive.isComplete()) return;
        SessionResult r = archive.verify(source);
        result = r;
        feed.call(listener -> listener.completed(r));
    }
}
