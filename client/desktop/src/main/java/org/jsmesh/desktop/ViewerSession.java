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
import org.jsmesh.session.SessionOptions;
import org.jsmesh.session.StreamingSession;

/** A {@link StreamingSession} that feeds a {@link SessionView} on a thread of its own, where meshes are made ready to draw. */
final class ViewerSession implements AutoCloseable {
    private static final int MESH_MILLIS = 60;

    private final SessionView view;
    private final ExecutorService viewing = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "jsm-view");
        thread.setDaemon(true);
        return thread;
    });
    private final StreamingSession session;

    /**
     * @param location address of an archive or a manifest, or the path of an archive
     * @throws IllegalArgumentException when it is neither
     */
    ViewerSession(String location, SessionView.Display display) {
        view = new SessionView(display, location);
        SessionOptions options = SessionOptions.defaults().withMeshMillis(MESH_MILLIS);
        session = location.matches("[A-Za-z][A-Za-z0-9+.-]+:.*")
                ? StreamingSession.open(address(location), options, view, this::onViewThread)
                : StreamingSession.open(path(location), options, view, this::onViewThread);
    }

    /** One round; at its end all that it brought has been displayed, the proof as well if it brought the last batch. */
    CompletableFuture<Void> refine(int waitMillis) {
        onViewThread(view::requested);
        return displayed(session.refine(waitMillis)
                .thenCompose(round -> session.progress().isComplete()
                        ? session.complete()
                        : CompletableFuture.completedFuture(null)));
    }

    /** All the rest. */
    CompletableFuture<Void> complete() {
        onViewThread(view::requested);
        return displayed(session.complete());
    }

    @Override
    public void close() {
        session.close();
        viewing.shutdown();
    }

    private CompletableFuture<Void> displayed(CompletableFuture<?> call) {
        return call.handleAsync(
                (result, error) -> {
                    Throwable cause = error instanceof CompletionException ? error.getCause() : error;
                    // The listener has heard of failures of the network and the archive, and nobody needs to hear of a
                    // closed window.
                    boolean known =
                            cause == null || cause instanceof IOException || cause instanceof CancellationException;
                    if (!known) view.broken(cause);
                    return null;
                },
                this::onViewThread);
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
            return new URI(location);
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
