package org.jsmesh.session;

import java.io.IOException;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jsmesh.mesh.Mesh;

/**
 * Calls a listener on its executor. For a listener that is still busy, it keeps only the latest progress and the latest
 * mesh.
 */
final class ListenerFeed {
    private record Refined(Mesh mesh, SessionProgress progress) {}

    private final SessionListener listener;
    private final Executor executor;
    private final AtomicReference<SessionProgress> progress = new AtomicReference<>();
    private final AtomicInteger untaken = new AtomicInteger(); // steps
    private final AtomicReference<Refined> refined = new AtomicReference<>();

    ListenerFeed(SessionListener listener, Executor executor) {
        this.listener = listener;
        this.executor = executor;
    }

    void call(Consumer<SessionListener> event) {
        executor.execute(() -> event.accept(listener));
    }

    void preparing(String stage, double fraction) {
        call(hearing -> hearing.preparing(stage, fraction));
    }

    void retrying(IOException error, int attempt, long pauseMillis) {
        call(hearing -> hearing.retrying(error, attempt, pauseMillis));
    }

    void progressed(SessionProgress now) {
        if (progress.getAndSet(now) == null) executor.execute(() -> listener.progressed(progress.getAndSet(null)));
    }

    void refined(Mesh mesh, SessionProgress now) {
        if (refined.getAndSet(new Refined(mesh, now)) != null) return;
        executor.execute(() -> {
            Refined latest = refined.getAndSet(null);
            listener.refined(latest.mesh(), latest.progress());
        });
    }

    /**
     * Gives a step.
     *
     * @param making makes it; it gets what the listener is to call
     */
    void stepped(Function<Runnable, MeshStep> making) {
        untaken.incrementAndGet();
        MeshStep step = making.apply(untaken::decrementAndGet);
        call(hearing -> hearing.stepped(step));
    }

    /** Whether the listener has not taken a step yet. */
    boolean isAwaited() {
        return untaken.get() > 0;
    }
}
