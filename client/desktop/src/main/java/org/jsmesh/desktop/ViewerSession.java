package org.jsmesh.desktop;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Function;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.desktop.chart.LoadRecord;
import org.jsmesh.desktop.draw.ErrorMap;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.files.ModelAddress;
import org.jsmesh.encode.measure.DistanceMeter;
import org.jsmesh.mesh.Note;
import org.jsmesh.session.ArrivedBytes;
import org.jsmesh.session.RenewingSession;
import org.jsmesh.session.SessionOptions;
import org.jsmesh.session.StreamingSession;

/**
 * A {@link StreamingSession} that feeds a {@link SessionView} on a thread of its own. That thread prepares meshes for
 * drawing. A second one decodes earlier resolutions.
 */
final class ViewerSession implements AutoCloseable {
    private static final int MESH_MILLIS = 60;
    private static final int NONE = -1;

    private final String location;
    private final SessionOptions options;
    private final SessionView view;
    private final SessionFacts facts;
    private final SessionView.Display display;
    private final ExecutorService viewing = thread("jsm-view");
    private final ExecutorService decoding = thread("jsm-resolutions");
    private final RenewingSession session;
    private final LoadSampler sampler;
    private volatile Resolutions resolutions;
    private volatile int wished = NONE;

    /**
     * @param location address of an archive or a manifest, or the path of an archive
     * @param cache folder in which archives are kept, or null
     * @throws IllegalArgumentException when the location is neither
     */
    ViewerSession(String location, Path cache, SessionView.Display display) {
        this(location, location, List.of(), cache, display);
    }

    /**
     * @param name of the model, for messages
     * @param repairs what was mended or lost when the archive was made here
     */
    ViewerSession(String location, String name, List<Note> repairs, Path cache, SessionView.Display display) {
        this.location = location;
        this.display = display;
        options = SessionOptions.defaults().withMeshMillis(MESH_MILLIS).withCache(cache);
        view = new SessionView(display, name);
        facts = new SessionFacts(view, repairs, display::show);
        session = new RenewingSession(this::open, view::renewed, this::onViewThread);
        sampler = new LoadSampler(() -> session.session().progress());
    }

    private static ExecutorService thread(String name) {
        return Executors.newSingleThreadExecutor(task -> {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            return thread;
        });
    }

    private StreamingSession open() {
        ArrivedBytes arrived = new ArrivedBytes();
        SessionOptions own = options.withArrived(arrived);
        StreamingSession opened = ModelAddress.isAddress(location)
                ? StreamingSession.open(ModelAddress.address(location), own, facts, this::onViewThread)
                : StreamingSession.open(ModelAddress.path(location), own, facts, this::onViewThread);
        resolutions = new Resolutions(arrived);
        wished = NONE;
        onViewThread(() -> facts.begun(arrived));
        return opened;
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
        return session.call(s -> {
                    sampler.begin();
                    return work.apply(s).whenComplete((result, error) -> sampler.end());
                })
                .handleAsync((result, error) -> displayed(error), this::onViewThread);
    }

    /** How it was loaded so far. */
    LoadRecord load() {
        return sampler.load();
    }

    /** Gives up what is under way; what has arrived is kept. */
    void stop() {
        session.session().cancel();
    }

    /** Ends the pause before the next attempt. */
    void tryNow() {
        session.session().tryNow();
    }

    /**
     * Displays an earlier resolution as soon as it is decoded, and how far it is from the newest one as soon as that is
     * measured, unless another one was asked for by then.
     *
     * @param batch that has arrived
     * @param newest batch that has arrived; the batch itself when nothing is to be measured
     * @param header of the archive
     */
    void showEarlier(int batch, int newest, ArchiveHeader header) {
        wished = batch;
        Resolutions from = resolutions;
        decoding.execute(() -> {
            if (wished != batch) return;
            try {
                Resolutions.Resolution shown = from.after(batch, header.batches());
                display(batch, shown, null);
                if (batch == newest) return;
                DistanceMeter meter =
                        new DistanceMeter(from.after(newest, header.batches()).mesh());
                Framing framing = Framing.of(header.bounds(), header.up());
                ErrorMap errors = ErrorMap.of(shown.mesh(), meter, framing, () -> wished != batch);
                if (errors != null) display(batch, shown, errors);
            } catch (IOException | RuntimeException | OutOfMemoryError e) {
                showNoEarlier(batch, e);
            }
        });
    }

    /** What is shown and proven stays so. */
    private void showNoEarlier(int batch, Throwable error) {
        onViewThread(() -> {
            if (wished == batch) display.showNoEarlier(view.trouble(error));
        });
    }

    private void display(int batch, Resolutions.Resolution shown, ErrorMap errors) {
        onViewThread(() -> {
            if (wished != batch) return;
            try {
                display.showEarlier(batch, view.scene(shown), errors);
            } catch (RuntimeException | OutOfMemoryError e) {
                showNoEarlier(batch, e);
            }
        });
    }

    /** What is asked for no longer is not displayed. */
    void showNewest() {
        wished = NONE;
    }

    @Override
    public void close() {
        wished = NONE;
        sampler.close();
        session.close();
        decoding.shutdown();
        viewing.shutdown();
    }

    private static Throwable cause(Throwable error) {
        return error instanceof CompletionException ? error.getCause() : error;
    }

    private Void displayed(Throwable error) {
        Throwable cause = cause(error);
        if (cause instanceof CancellationException) view.stopped();
        // The listener has heard of failures of the network and the archive, and nobody needs to hear of a closed
        // window.
        boolean known = cause == null || cause instanceof IOException || cause instanceof CancellationException;
        if (!known) view.broken(cause);
        if (cause == null) view.ended();
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
}
