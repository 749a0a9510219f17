package org.jsmesh.session;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * A session that begins again when the archive at its address is replaced by another one while it is fetched: the call
 * that notices opens a new session and is repeated there. At most {@value #MOST_RENEWALS} times, because a server whose
 * archive changes with every request must not be asked for ever; then the call fails with
 * {@link ArchiveChangedException}, as one of a plain {@link StreamingSession} does at once.
 *
 * <pre>
 *     RenewingSession session = new RenewingSession(
 *             () -&gt; StreamingSession.open(uri, options, listener, executor), () -&gt; forgetTheMesh(), executor);
 *     session.call(s -&gt; s.refine(2000)).join();
 * </pre>
 *
 * Thread-safe.
 */
public final class RenewingSession implements AutoCloseable {
    private static final int MOST_RENEWALS = 3;

    private final Supplier<StreamingSession> opening;
    private final Runnable renewed;
    private final Executor executor;
    private volatile StreamingSession session;
    private int renewals;
    private boolean closed;

    /**
     * Opens the first session.
     *
     * @param opening opens a session from the beginning; throws what {@link StreamingSession#open} throws
     * @param renewed told before another session is opened: what was shown is of an archive that is gone
     * @param executor on which {@code renewed} and {@code opening} are called then; the listener's will do
     */
    public RenewingSession(Supplier<StreamingSession> opening, Runnable renewed, Executor executor) {
        this.opening = opening;
        this.renewed = renewed;
        this.executor = executor;
        session = opening.get();
    }

    /** {@return the session that is open now; a call that notices another archive closes it and opens another} */
    public StreamingSession session() {
        return session;
    }

    /**
     * Calls the session, and calls the next one when the archive turns out to be another one by now.
     *
     * @param <T> what the call brings
     * @param work makes one call of the session that it is given; it may run several times, and later runs are on the
     *     executor
     * @return the outcome of the last call; it fails for the same reason as that call
     */
    public <T> CompletableFuture<T> call(Function<StreamingSession, CompletableFuture<T>> work) {
        StreamingSession asked;
        CompletableFuture<T> answer;
        synchronized (this) {
            // Or else it might be closed in between.
            asked = session;
            answer = work.apply(asked);
        }
        return answer.handleAsync(
                        (result, error) -> {
                            Throwable cause = error instanceof CompletionException ? error.getCause() : error;
                            if (cause instanceof ArchiveChangedException && isRenewed(asked)) return call(work);
                            return cause == null
                                    ? CompletableFuture.completedFuture(result)
                                    : CompletableFuture.<T>failedFuture(cause);
                        },
                        executor)
                .thenCompose(Function.identity());
    }

    private synchronized boolean isRenewed(StreamingSession asked) {
        if (closed) return false;
        if (asked != session) return true; // another call has seen to it
        if (renewals++ >= MOST_RENEWALS) return false;
        asked.close();
        renewed.run();
        session = opening.get();
        return true;
    }

    /** Closes the session that is open; nothing is begun again after that. */
    @Override
    public void close() {
        StreamingSession last;
        synchronized (this) {
            closed = true;
            last = session;
        }
        last.close();
    }
}
