package org.jsmesh.desktop;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import com.jogamp.opengl.GLException;
import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import javax.swing.JPopupMenu;
import javax.swing.ToolTipManager;
import org.jsmesh.desktop.dialog.Dialogs;
import org.jsmesh.desktop.files.UserSettings;

/** The windows of this program, with one look and one memory. Used on the event dispatch thread. */
final class Windows {
    private final ViewerOptions options;
    private final UserSettings settings;
    private final Function<Component, Dialogs> dialogs;
    private final Runnable onEnd;
    private final List<ViewerWindow> open = new ArrayList<>();
    private final Background background = new Background(this::endIfDone);

    /**
     * @param dialogs makes those of a window
     * @param onEnd called when the last window has been closed and nothing is saved or removed any more
     */
    Windows(ViewerOptions options, UserSettings settings, Function<Component, Dialogs> dialogs, Runnable onEnd) {
        this.options = options;
        this.settings = settings;
        this.dialogs = dialogs;
        this.onEnd = onEnd;
        // The system draws the picture above Swing's light-weight windows.
        ToolTipManager.sharedInstance().setLightWeightPopupEnabled(false);
        JPopupMenu.setDefaultLightWeightPopupEnabled(false);
        setLook();
    }

    UserSettings settings() {
        return settings;
    }

    Background background() {
        return background;
    }

    /**
     * Opens a window.
     *
     * @param location what it shows, or null for an empty one
     * @throws ViewerException when there is no OpenGL
     */
    ViewerWindow open(String location) {
        ViewerWindow window;
        try {
            window = new ViewerWindow(this, options, dialogs);
        } catch (GLException | UnsatisfiedLinkError e) {
            throw new ViewerException(ScreenshotRun.noOpenGl(e), e);
        }
        open.add(window);
        if (location != null) window.open(location);
        return window;
    }

    void closed(ViewerWindow window) {
        if (open.remove(window)) endIfDone();
    }

    private void endIfDone() {
        if (open.isEmpty() && background.isIdle()) onEnd.run();
    }

    void closeAll() {
        for (ViewerWindow window : List.copyOf(open)) window.frame().dispose();
    }

    void toggleDark() {
        settings.setDark(!settings.isDark());
        setLook();
        FlatLaf.updateUI();
        open.forEach(ViewerWindow::lookChanged);
    }

    private void setLook() {
        if (settings.isDark()) FlatDarkLaf.setup();
        else FlatLightLaf.setup();
    }
}
