package org.jsmesh.desktop;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import javax.swing.SwingUtilities;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.desktop.chart.LoadRecord;
import org.jsmesh.desktop.draw.ErrorMap;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.SceneStep;
import org.jsmesh.desktop.files.ModelAddress;
import org.jsmesh.desktop.files.ModelImport;
import org.jsmesh.desktop.panel.ModelFacts;
import org.jsmesh.files.Explanation;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;

/**
 * One model in one window, from its address to its end: a model file is encoded first, in the background. Used on the
 * event dispatch thread, where it also calls the window, until it is closed.
 */
final class ModelRun implements SessionView.Display, AutoCloseable {
    private final ModelAddress address;
    private final ViewerOptions options;
    private final SessionView.Display window;
    private final Background background;
    private ModelFacts facts = ModelFacts.NONE;
    private ViewerSession session;
    private ModelImport imported;
    private volatile boolean closed;
    private volatile boolean stopped;

    /** @param background where it encodes, and is closed */
    ModelRun(ModelAddress address, ViewerOptions options, SessionView.Display window, Background background) {
        this.address = address;
        this.options = options;
        this.window = window;
        this.background = background;
    }

    /** How it was loaded so far. */
    LoadRecord load() {
        return session == null ? new LoadRecord() : session.load();
    }

    ModelAddress address() {
        return address;
    }

    /** Begins with a round, or with everything. */
    void start(boolean original) {
        if (address.kind() == ModelAddress.Kind.MODEL) encode(original);
        else begin(address.location(), List.of(), original);
    }

    private void encode(boolean original) {
        stopped = false;
        Path model = Path.of(address.location());
        show(ViewState.START.preparing("Encoding " + address.title() + ".", 0));
        background.run("jsm-encode", () -> encode(model, original));
    }

    private void encode(Path model, boolean original) {
        try {
            ModelImport made = ModelImport.of(model, new Progress());
            SwingUtilities.invokeLater(() -> take(made, original));
        } catch (CancellationException e) {
            show(ViewState.EMPTY.withMessage("Encoding " + address.title() + " was stopped."));
        } catch (OutOfMemoryError e) {
            show(failure(SessionView.trouble(model.toString(), e)));
        } catch (IOException | RuntimeException | Error e) {
            show(failure(Explanation.of(model, e).toString()));
        }
    }

    private static ViewState failure(String words) {
        return ViewState.START.with(ViewState.Phase.ERROR).withMessage(words);
    }

    private void take(ModelImport made, boolean original) {
        if (closed) {
            background.run("jsm-close", made::close);
            return;
        }
        imported = made;
        begin(made.archive().toString(), made.notes(), original);
    }

    private void begin(String location, List<Note> repairs, boolean original) {
        try {
            session = new ViewerSession(location, address.location(), repairs, options.cache(), this);
        } catch (IllegalArgumentException e) {
            show(failure(SessionView.words(e)));
            return;
        }
        // What is on this machine already costs no wait.
        if (original || address.kind() == ModelAddress.Kind.MODEL) session.complete();
        else session.refine(options.waitMillis());
    }

    /** One more round; a model that could not be opened is tried again. */
    void moreDetail() {
        if (session == null) start(false);
        else session.refine(options.waitMillis());
    }

    /** All the rest. */
    void original() {
        if (session == null) start(true);
        else session.complete();
    }

    /** Gives up what is under way. */
    void stop() {
        stopped = true;
        if (session != null) session.stop();
    }

    /** Ends the pause before the next attempt. */
    void tryNow() {
        if (session != null) session.tryNow();
    }

    /** Shows an earlier resolution as soon as it is there, see {@link ViewerSession#showEarlier}. */
    void showEarlier(int batch, int newest, ArchiveHeader header) {
        if (session != null) session.showEarlier(batch, newest, header);
    }

    /** Shows no earlier resolution any more. */
    void showNewest() {
        if (session != null) session.showNewest();
    }

    /**
     * Loads everything, then does something with it.
     *
     * @param then on the event dispatch thread; what is missing by then could not be loaded
     */
    void whenComplete(Runnable then) {
        if (session == null || facts.result() != null) then.run();
        else session.complete().thenRun(() -> later(then));
    }

    @Override
    public void close() {
        closed = true;
        stop();
        // The end of a session and of a large file may last.
        if (session != null || imported != null) background.run("jsm-close", this::end);
    }

    private void end() {
        if (session != null) session.close();
        if (imported != null) imported.close();
    }

    private void later(Runnable work) {
        SwingUtilities.invokeLater(() -> {
            if (!closed) work.run();
        });
    }

    @Override
    public void frame(Framing framing) {
        later(() -> window.frame(framing));
    }

    @Override
    public void show(Scene scene) {
        later(() -> window.show(scene));
    }

    @Override
    public boolean isLive() {
        return window.isLive();
    }

    @Override
    public void show(SceneStep step) {
        later(() -> window.show(step));
    }

    @Override
    public void show(ViewState state) {
        later(() -> window.show(state));
    }

    @Override
    public void show(ModelFacts now) {
        later(() -> {
            facts = now;
            window.show(now);
        });
    }

    @Override
    public void showEarlier(int batch, Scene earlier, ErrorMap errors) {
        later(() -> window.showEarlier(batch, earlier, errors));
    }

    @Override
    public void showNoEarlier(String reason) {
        later(() -> window.showNoEarlier(reason));
    }

    /** Tells the window of the encoding, not more often than it is seen. */
    private final class Progress implements ProgressListener {
        private static final long PACE_NANOS = 50_000_000;
        private String last = "";
        private long told;

        @Override
        public synchronized void progress(String stage, double fraction) {
            long now = System.nanoTime();
            if (stage.equals(last) && now - told < PACE_NANOS) return;
            last = stage;
            told = now;
            show(ViewState.START.preparing(
                    "Encoding " + address.title() + ": " + stage + ", " + Math.round(100 * fraction) + "%.", fraction));
        }

        @Override
        public boolean isCancelled() {
            return stopped || closed;
        }
    }
}
