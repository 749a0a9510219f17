package org.jsmesh.desktop;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.OriginalWords;
import org.jsmesh.archive.Provenance;
import org.jsmesh.desktop.draw.ErrorMap;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.LiveScenes;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.SceneStep;
import org.jsmesh.desktop.draw.TextureImages;
import org.jsmesh.desktop.panel.ModelFacts;
import org.jsmesh.display.CreaseAngle;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.session.MeshStep;
import org.jsmesh.session.RoundReport;
import org.jsmesh.session.SessionListener;
import org.jsmesh.session.SessionProgress;
import org.jsmesh.session.SessionResult;

/**
 * Turns what a session reports into states and scenes. The session calls its methods, one at a time. The display must
 * take its calls on that thread.
 */
final class SessionView implements SessionListener {
    /** Who shows it. */
    interface Display {
        /** The size of the model is known. */
        void frame(Framing framing);

        /** A whole mesh; not called where the display {@link #isLive}. */
        void show(Scene scene);

        /** What a step changes; called where the display {@link #isLive}. */
        default void show(SceneStep step) {}

        void show(ViewState state);

        /** Whether it wants steps instead of whole meshes. The answer is always the same. */
        default boolean isLive() {
            return false;
        }

        /** What is known of the model has changed. */
        default void show(ModelFacts facts) {}

        /**
         * An earlier resolution was asked for and is there.
         *
         * @param batch after which it is
         * @param errors how far it is from the newest one; null when that was not asked for, or is not measured yet
         */
        default void showEarlier(int batch, Scene earlier, ErrorMap errors) {}

        /** An earlier resolution was asked for and cannot be shown, for that reason. */
        default void showNoEarlier(String reason) {}
    }

    private final Display display;
    private final String name;
    private TextureImages images = new TextureImages();
    private String notice;
    private ViewState state = ViewState.START;
    private Framing framing;
    private ArchiveHeader header;
    private LiveScenes live;
    private SessionResult result;

    /** @param name of the archive, for messages */
    SessionView(Display display, String name) {
        this.display = display;
        this.name = name;
    }

    /** The user asked for a round, or for the rest. */
    void requested() {
        // At the end nothing more will come, and the session says so once.
        if (state.isOver()) {
            display.show(state);
            return;
        }
        boolean shown = state.progress() != null && state.progress().batches() > 0;
        change(state.with(shown ? ViewState.Phase.REFINING : ViewState.Phase.LOADING)
                .withMessage(notice));
    }

    /** The user has given up what was under way. */
    void stopped() {
        change(state.with(ViewState.Phase.IDLE).withMessage(notice));
    }

    /** What was asked for has come. The proof is told once, and may have been shown before something went wrong. */
    void ended() {
        boolean waits = state.phase() == ViewState.Phase.REFINING || state.phase() == ViewState.Phase.CHECKING;
        if (waits && result != null) showOutcome();
    }

    /** There is another archive by now. The next scenes are of that one, from its beginning. */
    void renewed() {
        notice = "The model was changed on the server while it was loading. This is the new one, from its beginning.";
        images = new TextureImages();
        result = null;
        change(ViewState.START.withMessage(notice));
    }

    /**
     * The scene of an earlier resolution of this model. On the thread of the session's calls, after {@link #opened}.
     */
    Scene scene(Resolutions.Resolution earlier) {
        Scene scene = scene(earlier.mesh());
        boolean known = earlier.levels().length > 0;
        return known
                ? scene.withLevels(
                        earlier.mesh(), earlier.levels(), header.levels().size())
                : scene;
    }

    private Scene scene(Mesh mesh) {
        double crease = CreaseAngle.cosine(mesh.faces(), header.batches().faces(0), header.faces());
        return Scene.of(mesh, crease, header.isClosed(), framing, images);
    }

    private String remark() {
        return images.problem() == null ? notice : images.problem();
    }

    /** A remark and what the archive does not have of its file; null for neither. */
    private String withLosses(String remark) {
        Provenance from = header.provenance();
        List<String> parts = new ArrayList<>();
        if (remark != null) parts.add(remark);
        if (OriginalWords.hasWarning(from)) parts.add(sentence(OriginalWords.warning(from)));
        if (!OriginalWords.notKept(from).isEmpty()) parts.add(sentence(OriginalWords.notKept(from)));
        return parts.isEmpty() ? null : String.join(" ", parts);
    }

    private static String sentence(String clause) {
        return Character.toUpperCase(clause.charAt(0)) + clause.substring(1) + ".";
    }

    @Override
    public void preparing(String stage, double fraction) {
        change(state.preparing(
                "The server prepares the model: " + stage + ", " + Math.round(100 * fraction) + "%.", fraction));
    }

    @Override
    public void opened(ArchiveHeader opened) {
        header = opened;
        framing = Framing.of(header.bounds(), header.up());
        live = new LiveScenes(header, framing, images);
        display.frame(framing);
        change(state.with(awake()).withLevels(header.levels().size()).withMessage(notice));
    }

    @Override
    public void progressed(SessionProgress progress) {
        // Bytes may still arrive after a round has ended. Only the first batch changes the phase.
        boolean grown = progress.bytes()
                > (state.progress() == null ? 0 : state.progress().bytes());
        ViewState next = state.with(progress);
        if (grown && state.phase() == ViewState.Phase.RETRYING)
            next = next.with(ViewState.Phase.LOADING).withMessage(notice);
        boolean started = next.phase() == ViewState.Phase.LOADING && progress.batches() > 0;
        change(started ? next.with(ViewState.Phase.REFINING) : next);
    }

    /** The phase when something has come that was waited for. */
    private ViewState.Phase awake() {
        boolean waited = state.phase() == ViewState.Phase.PREPARING || state.phase() == ViewState.Phase.RETRYING;
        return waited ? ViewState.Phase.LOADING : state.phase();
    }

    @Override
    public void retrying(IOException error, int attempt, long pauseMillis) {
        String next = pauseMillis < 0
                ? "This round ends before the next attempt; ask again."
                : "Attempt " + attempt + " follows in " + WaitConverter.words((int) Math.max(1, pauseMillis)) + ".";
        change(state.with(ViewState.Phase.RETRYING)
                .withMessage("The connection was lost: " + clause(words(error)) + " " + next
                        + " What has arrived is kept."));
    }

    private static String clause(String words) {
        return words.endsWith(".") ? words : words + ".";
    }

    @Override
    public void refined(Mesh mesh, SessionProgress progress) {
        display.show(scene(mesh));
        change(state.with(progress).withMessage(remark()));
    }

    @Override
    public boolean isLive() {
        return display.isLive();
    }

    @Override
    public void stepped(MeshStep step) {
        display.show(live.next(step));
        change(state.with(step.progress()).withMessage(remark()));
    }

    @Override
    public void roundEnded(RoundReport round) {
        // What went wrong is still to be read.
        if (state.phase() == ViewState.Phase.ERROR) return;
        boolean atEnd = state.progress() != null && state.progress().isComplete();
        change(state.with(atEnd ? ViewState.Phase.CHECKING : ViewState.Phase.IDLE));
    }

    @Override
    public void completed(SessionResult end) {
        result = end;
        if (!isLive()) display.show(scene(result.mesh()));
        showOutcome();
    }

    private void showOutcome() {
        if (result.identical()) {
            boolean whole = !OriginalWords.hasWarning(header.provenance());
            change(state.with(whole ? ViewState.Phase.IDENTICAL : ViewState.Phase.INCOMPLETE)
                    .withMessage(withLosses(remark())));
        } else {
            change(state.with(ViewState.Phase.DIFFERENT).withMessage(result.difference()));
        }
    }

    @Override
    public void failed(IOException error) {
        String words = words(error);
        if (error instanceof MalformedStreamException malformed) {
            if (!words.startsWith(name)) words = name + ": " + words;
            if (malformed.offset() == 0) words += "; make an archive of a model with jsm encode";
        }
        change(state.with(ViewState.Phase.ERROR).withMessage(words));
    }

    /** Something went wrong that no input caused: memory, or an error in this program. */
    void broken(Throwable error) {
        change(state.with(ViewState.Phase.ERROR).withMessage(trouble(error)));
    }

    /** What went wrong with this model. */
    String trouble(Throwable error) {
        return trouble(name, error);
    }

    /** What went wrong with a model or a file, and the remedy for a lack of memory. */
    static String trouble(String name, Throwable error) {
        return name + ": "
                + (error instanceof OutOfMemoryError
                        ? "there is not enough memory; start the viewer with more, for instance java -Xmx8g -jar"
                                + " jsm-viewer.jar"
                        : words(error));
    }

    /** Never empty: some exceptions of the JDK come without a message. */
    static String words(Throwable error) {
        return error.getMessage() == null || error.getMessage().isBlank() ? error.toString() : error.getMessage();
    }

    private void change(ViewState next) {
        state = next;
        display.show(next);
    }
}
