package org.jsmesh.desktop;

import java.awt.CardLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.dnd.DropTarget;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import javax.swing.Action;
import javax.swing.JFrame;
import javax.swing.JPanel;
import org.jsmesh.desktop.chart.LoadRecord;
import org.jsmesh.desktop.dialog.Dialogs;
import org.jsmesh.desktop.draw.DrawStyle;
import org.jsmesh.desktop.draw.ErrorMap;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.SceneStep;
import org.jsmesh.desktop.draw.Shading;
import org.jsmesh.desktop.files.Dropped;
import org.jsmesh.desktop.files.ModelAddress;
import org.jsmesh.desktop.panel.DetailSlider;
import org.jsmesh.desktop.panel.ModelFacts;
import org.jsmesh.desktop.panel.SidePanel;

/**
 * A window: the picture, or what to do without one; {@link SidePanel} beside it, {@link StatusBar} below. Used on the
 * event dispatch thread.
 */
final class ViewerWindow implements SessionView.Display {
    private static final String START = "start";
    private static final String PICTURE = "picture";
    private static final String TITLE = "jSM";

    private final Windows windows;
    private final ViewerOptions options;
    private final ViewerActions actions;
    private final JFrame frame = new JFrame(TITLE);
    private final CardLayout cards = new CardLayout();
    private final JPanel centre = new JPanel(cards);
    private final SceneCanvas canvas;
    private final StartPanel start;
    private final SidePanel side;
    private final StatusBar status;
    private ModelRun run;
    private ViewState state = ViewState.EMPTY;
    private ModelFacts facts = ModelFacts.NONE;
    private boolean pictured;
    private boolean earlier;
    private int measured;

    /** @param dialogs makes those of the window */
    ViewerWindow(Windows windows, ViewerOptions options, Function<Component, Dialogs> dialogs) {
        this.windows = windows;
        this.options = options;
        actions = new ViewerActions(
                new WindowCommands(this, windows, dialogs.apply(frame)), WaitConverter.words(options.waitMillis()));
        canvas = new SceneCanvas(this::cannotDraw);
        start = new StartPanel(actions, this::open);
        side = new SidePanel(this::showResolution, canvas::diagonalPixels);
        status = new StatusBar(actions);
        build();
        style(s -> options.style());
        show(state);
    }

    private void build() {
        CameraControls.install(canvas);
        Component picture = canvas.component();
        picture.addKeyListener(new MenuKeys());
        picture.setPreferredSize(
                new Dimension(options.size().width(), options.size().height()));
        centre.add(start.component(), START);
        centre.add(picture, PICTURE);
        frame.setJMenuBar(ViewerMenu.of(
                actions,
                windows.settings()::recent,
                this::open,
                () -> windows.settings().forgetRecent()));
        setSidePanel(windows.settings().isPanelShown());
        actions.dark.putValue(Action.SELECTED_KEY, windows.settings().isDark());
        Dropped dropped = new Dropped(this::open);
        new DropTarget(picture, dropped);
        new DropTarget(frame.getRootPane(), dropped);
        WindowFrame.show(frame, centre, side.component(), status.component(), this::closed);
    }

    private void closed() {
        if (run != null) run.close();
        run = null;
        windows.closed(this);
    }

    JFrame frame() {
        return frame;
    }

    ViewerActions actions() {
        return actions;
    }

    ViewState state() {
        return state;
    }

    ModelFacts facts() {
        return facts;
    }

    SidePanel side() {
        return side;
    }

    SceneCanvas canvas() {
        return canvas;
    }

    /** The model, or null. */
    ModelRun run() {
        return run;
    }

    /** Says what became of a wish. */
    void note(String words, boolean failure) {
        status.note(words, failure);
    }

    /** Nothing can be drawn, whatever the session tells. Without words it can again. */
    void cannotDraw(String words) {
        status.problem(words);
    }

    /** A wish that has to do with loading begins. */
    void ask(Runnable request) {
        if (!state.canRefine() || run == null) return;
        status.clearNote();
        show(state.with(ViewState.Phase.REFINING).withMessage(null));
        request.run();
    }

    /** What was dropped or chosen: the first here, each further one in a window of its own. */
    void open(List<?> locations) {
        for (int i = 0; i < locations.size(); i++) {
            if (i == 0) open(locations.get(i).toString());
            else windows.open(locations.get(i).toString());
        }
    }

    /** Shows another model instead of this one. */
    void open(String location) {
        ModelAddress address;
        try {
            address = ModelAddress.of(location);
        } catch (IllegalArgumentException e) {
            if (run == null) show(ViewState.START.with(ViewState.Phase.ERROR).withMessage(SessionView.words(e)));
            else status.note(SessionView.words(e), true);
            return;
        }
        windows.settings().opened(address.lasting());
        if (address.kind() != ModelAddress.Kind.REMOTE) windows.settings().used(Path.of(address.location()));
        begin(address, options.original());
    }

    /** Loads a model from its beginning. */
    void begin(ModelAddress address, boolean original) {
        if (run != null) run.close();
        pictured = false;
        measured = 0;
        showLive();
        status.clearNote();
        frame.setTitle(address.title() + " – " + TITLE);
        run = new ModelRun(address, options, this, windows.background());
        show(ModelFacts.NONE);
        show(ViewState.START);
        run.start(original);
    }

    @Override
    public void frame(Framing framing) {
        canvas.frame(framing);
    }

    @Override
    public boolean isLive() {
        return true;
    }

    @Override
    public void show(Scene scene) {
        canvas.show(scene);
        showPicture();
    }

    @Override
    public void show(SceneStep step) {
        canvas.show(step);
        showPicture();
    }

    @Override
    public void showEarlier(int batch, Scene scene, ErrorMap errors) {
        if (side.detail().isNewest()) return;
        earlier = true;
        if (errors == null) canvas.show(scene);
        canvas.show(errors);
        side.largestError(errors == null ? Double.NaN : errors.farthest());
    }

    @Override
    public void showNoEarlier(String reason) {
        status.note("This resolution cannot be shown. " + reason, true);
    }

    /** Shows what is refined, in the place of an earlier resolution. */
    private void showLive() {
        earlier = false;
        canvas.show((Scene) null);
        canvas.show((ErrorMap) null);
        side.largestError(0);
    }

    @Override
    public void show(ViewState next) {
        state = next;
        status.show(next, pictured);
        showCard();
        actions.show(state, facts, run != null);
        measureAgain();
    }

    @Override
    public void show(ModelFacts now) {
        facts = now;
        side.show(now, run == null ? new LoadRecord() : run.load());
        if (side.detail().isNewest() && earlier) showResolution(DetailSlider.NEWEST);
        actions.show(state, facts, run != null);
        measureAgain();
    }

    /** Distances are to the newest mesh, and there is a newer one; while more of them come, that would be in vain. */
    private void measureAgain() {
        boolean isWanted =
                canvas.style().shading() == Shading.ERROR && !side.detail().isNewest();
        if (isWanted && !state.isBusy() && facts.batches() > measured)
            showResolution(side.detail().shown());
    }

    private void showPicture() {
        if (pictured) return;
        pictured = true;
        showCard();
        status.show(state, true);
        canvas.component().requestFocusInWindow();
    }

    private void showCard() {
        if (!pictured) start.show(state, windows.settings().recent());
        cards.show(centre, pictured ? PICTURE : START);
    }

    /** The user has moved the control for resolutions. */
    private void showResolution(int batch) {
        if (run == null) return;
        if (batch == DetailSlider.NEWEST) {
            run.showNewest();
            showLive();
        } else {
            boolean isMeasured = canvas.style().shading() == Shading.ERROR;
            if (isMeasured) measured = facts.batches();
            run.showEarlier(batch, isMeasured ? facts.batches() - 1 : batch, facts.header());
        }
    }

    /** Draws in another style from now on. */
    void style(UnaryOperator<DrawStyle> change) {
        Shading before = canvas.style().shading();
        DrawStyle style = change.apply(canvas.style());
        canvas.style(style);
        actions.show(style);
        side.show(style);
        boolean lacksErrors = style.shading() == Shading.ERROR && before != Shading.ERROR;
        if (lacksErrors && !side.detail().isNewest())
            showResolution(side.detail().shown());
    }

    /** Takes the colours of the new look. */
    void lookChanged() {
        actions.dark.putValue(Action.SELECTED_KEY, windows.settings().isDark());
        show(state);
        show(facts);
    }

    void setSidePanel(boolean shown) {
        side.component().setVisible(shown);
        actions.sidePanel.putValue(Action.SELECTED_KEY, shown);
        frame.revalidate();
    }
}
