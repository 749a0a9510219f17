package org.jsmesh.desktop;

import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.EnumMap;
import java.util.Map;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;
import org.jsmesh.desktop.draw.DrawStyle;
import org.jsmesh.desktop.draw.Shading;
import org.jsmesh.desktop.panel.ModelFacts;

/**
 * What a user can do in a window, each with its key; menus and buttons are made of these. What is not possible now is
 * off. Used on the event dispatch thread.
 */
final class ViewerActions {
    private static final int CTRL = Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx();
    private static final int SHIFT = InputEvent.SHIFT_DOWN_MASK;

    final Action newWindow;
    final Action openFile;
    final Action openAddress;
    final Action paste;
    final Action saveShown;
    final Action saveOriginal;
    final Action saveArchive;
    final Action savePicture;
    final Action close;
    final Action quit;
    final Action showAll;
    final Action wireframe;
    final Action sidePanel;
    final Action dark;
    final Action moreDetail;
    final Action original;
    final Action stop;
    final Action tryNow;
    final Action reload;
    final Action coarser;
    final Action finer;
    final Action help;
    final Action about;
    final Map<Shading, Action> shadings = new EnumMap<>(Shading.class);

    /** @param waitWords the wait of a round, for people */
    ViewerActions(ViewerCommands c, String waitWords) {
        newWindow = of("New window", key(KeyEvent.VK_N, CTRL), c::newWindow);
        openFile = of("Open a file …", key(KeyEvent.VK_O, CTRL), c::openFile);
        openAddress = of("Open an address …", key(KeyEvent.VK_L, CTRL), c::openAddress);
        paste = of("Paste an address", key(KeyEvent.VK_V, CTRL), c::paste);
        saveShown = of("Save what is shown …", key(KeyEvent.VK_S, CTRL), () -> c.save(Saving.What.SHOWN));
        saveOriginal = of("Save the original …", key(KeyEvent.VK_S, CTRL | SHIFT), () -> c.save(Saving.What.ORIGINAL));
        saveArchive = of("Save the archive …", key(KeyEvent.VK_E, CTRL), () -> c.save(Saving.What.ARCHIVE));
        savePicture = of("Save the picture …", key(KeyEvent.VK_P, CTRL), c::savePicture);
        close = of("Close the window", key(KeyEvent.VK_W, CTRL), c::closeWindow);
        quit = of("Quit", key(KeyEvent.VK_Q, CTRL), c::quit);
        showAll = of("Show all of the model", key(KeyEvent.VK_HOME, 0), c::showAll);
        wireframe = of("Wireframe", key(KeyEvent.VK_W, 0), c::toggleWireframe);
        sidePanel = of("Side panel", key(KeyEvent.VK_F9, 0), c::toggleSidePanel);
        dark = of("Dark look", key(KeyEvent.VK_D, CTRL), c::toggleDark);
        moreDetail = of("More detail", key(KeyEvent.VK_SPACE, 0), c::moreDetail);
        original = of("Original", key(KeyEvent.VK_O, 0), c::original);
        stop = of("Stop", key(KeyEvent.VK_ESCAPE, 0), c::stop);
        tryNow = of("Try now", key(KeyEvent.VK_T, 0), c::tryNow);
        reload = of("Load it once more", key(KeyEvent.VK_F5, 0), c::reload);
        coarser = of("Coarser resolution", key(KeyEvent.VK_OPEN_BRACKET, 0), () -> c.step(false));
        finer = of("Finer resolution", key(KeyEvent.VK_CLOSE_BRACKET, 0), () -> c.step(true));
        help = of("Keys and mouse", key(KeyEvent.VK_F1, 0), c::help);
        about = of("About jSM", null, c::about);
        tip(moreDetail, "Refine for another " + waitWords + " (Space)");
        tip(original, "Load the rest: the original, bit for bit (O)");
        tip(stop, "Give up what is under way; what has arrived is kept (Esc)");
        tip(tryNow, "Do not wait for the next attempt (T)");
        shading(Shading.MATERIALS, "Materials", KeyEvent.VK_1, c);
        shading(Shading.FLAT, "Flat", KeyEvent.VK_2, c);
        shading(Shading.NORMALS, "Normals", KeyEvent.VK_3, c);
        shading(Shading.LEVELS, "Levels", KeyEvent.VK_4, c);
        shading(Shading.ERROR, "Distance to the newest", KeyEvent.VK_5, c);
    }

    private void shading(Shading shading, String name, int code, ViewerCommands c) {
        shadings.put(shading, of(name, key(code, 0), () -> c.shade(shading)));
    }

    private static KeyStroke key(int code, int modifiers) {
        return KeyStroke.getKeyStroke(code, modifiers);
    }

    private static void tip(Action action, String words) {
        action.putValue(Action.SHORT_DESCRIPTION, words);
    }

    private static Action of(String name, KeyStroke key, Runnable work) {
        Action action = new AbstractAction(name) {
            private static final long serialVersionUID = 1L;

            @Override
            public void actionPerformed(ActionEvent e) {
                work.run();
            }
        };
        action.putValue(Action.ACCELERATOR_KEY, key);
        return action;
    }

    /**
     * Turns off what is not possible now.
     *
     * @param open whether there is a model, shown or not
     */
    void show(ViewState state, ModelFacts facts, boolean open) {
        boolean shown = facts.isShown();
        boolean failed = state.phase() == ViewState.Phase.ERROR && !shown;
        moreDetail.putValue(Action.NAME, failed ? "Try again" : "More detail");
        moreDetail.setEnabled(open && state.canRefine());
        original.setEnabled(open && state.canRefine());
        stop.setEnabled(state.isBusy());
        tryNow.setEnabled(state.phase() == ViewState.Phase.RETRYING);
        reload.setEnabled(open && state.phase() != ViewState.Phase.PREPARING);
        saveShown.setEnabled(shown);
        boolean savable = shown && !state.isBusy() && state.phase() != ViewState.Phase.CHECKING;
        saveOriginal.setEnabled(savable && state.phase() != ViewState.Phase.DIFFERENT);
        saveArchive.setEnabled(savable);
        savePicture.setEnabled(shown);
        showAll.setEnabled(shown);
        wireframe.setEnabled(shown);
        coarser.setEnabled(facts.batches() > 1);
        finer.setEnabled(facts.batches() > 1);
        shadings.values().forEach(action -> action.setEnabled(shown));
    }

    /** Marks how the picture is drawn. */
    void show(DrawStyle style) {
        wireframe.putValue(Action.SELECTED_KEY, style.wireframe());
        shadings.forEach((shading, action) -> action.putValue(Action.SELECTED_KEY, shading == style.shading()));
    }
}
