package org.jsmesh.desktop;

import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Function;
import org.jsmesh.session.RenewingSession;
import org.jsmesh.session.SessionOptions;
import org.jsmesh.session.StreamingSession;

/**
 * A {@link StreamingSession} that feeds a {@link SessionView} on a thread of its own. That thread prepares meshes for
 * drawing.
 */
final class ViewerSession implements AutoCloseable {
    private static final int MESH_MILLIS = 60;

    private final String location;
    private final SessionOptions options;
    private final SessionView view;
    private final ExecutorService viewing = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "jsm-view");
        thread.setDaemon(true);
        return thread;
    });
    private final RenewingSession session;

    /**
     * @param location address of an archive or a manifest, or the path of an archive
     * @param cache folder in which archives are kept, or null
     * @throws IllegalArgumentException when the location is neither
     */
    ViewerSession(String location, Path cache, SessionView.Display display) {
        this.location = location;
        options = SessionOptions.defaults().withMeshMillis(MESH_MILLIS).withCache(cache);
        view = new SessionView(display, location);
        session = new RenewingSession(this::open, view::renewed, this::onViewThread);
    }

    private StreamingSession open() {
        return location.matches("[A-Za-z][A-Za-z0-9+.-]+:.*")
                ? StreamingSession.open(address(location), options, view, this::onViewThread)
                : StreamingSession.open(path(location), options, view, this::onViewThread);
    }

    /** Runs one round. At its end all that it brought is displayed, and also the proof if it brought the last batch. */
    CompletableFuture<Void> refine(int waitMillis) {
        return call(s -> s.refine(waitMillis)
                .thenCompose(round -> s.progress().isComplete()
                        ? s.complete().thenApply(result -> null)
                        : CompletableFuture.completedFuture(null)));
    }

    /** All the rest. */
    CompletableFuture<Void> complete() {
        return call(s -> s.complete().thenApply(result -> null));
    }

    /** Calls the session, which begins again when the archive turns out to be another one by now. */
    private CompletableFuture<Void> call(Function<StreamingSession, CompletableFuture<Object>> work) {
        onViewThread(view::requested);
        return session.call(work).handleAsync((result, error) -> displayed(error), this::onViewThread);
    }

    @Override
    public void close() {
        session.close();
        viewing.shutdown();
    }

    private static Throwable cause(Throwable error) {
        return error instanceof CompletionException ? error.getCause() : error;
    }

    private Void displayed(Throwable error) {
        Throwable cause = cause(error);
        // The listener has heard of failures of the network and the archive, and nobody needs to hear of a closed
        // window.
        boolean known = cause == null || cause instanceof IOException || cause instanceof CancellationException;
        if (!known) view.broken(cause);
        return null;
    }

    private void onViewThread(Runnable task) {
        if (viewing.isShutdown()) return;
        viewing.execute(() -> {
            try {
                task.run();
            } catch (RuntimeException | Error e) {
                view.broken(e);
            }
        });
    }

    private static URI address(String location) {
        try {
            // Letters beyond ASCII go percent-encoded over the wire.
            return new URI(new URI(location).toASCIIString());
        } catch (URISyntaxException e) {
            throw new IllegalArgumentException(location + " is no address: " + e.getReason(), e);
        }
    }

    private static Path path(String location) {
        try {
            return Path.of(location);
        } catch (InvalidPathException e) {
            throw new IllegalArgumentException(location + " is no path: " + e.getReason(), e);
        }
    }
}
