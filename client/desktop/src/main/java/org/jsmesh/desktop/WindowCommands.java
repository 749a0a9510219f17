package org.jsmesh.desktop;

import java.awt.Toolkit;
import java.util.List;
import org.jsmesh.desktop.dialog.Dialogs;
import org.jsmesh.desktop.dialog.HelpWords;
import org.jsmesh.desktop.draw.Shading;
import org.jsmesh.desktop.files.Dropped;

/** What the actions of a window do to it. */
final class WindowCommands implements ViewerCommands {
    private final ViewerWindow window;
    private final Windows windows;
    private final Dialogs dialogs;
    private final SaveCommands saving;

    WindowCommands(ViewerWindow window, Windows windows, Dialogs dialogs) {
        this.window = window;
        this.windows = windows;
        this.dialogs = dialogs;
        saving = new SaveCommands(dialogs, windows.settings(), windows.background(), window::note);
    }

    @Override
    public void newWindow() {
        windows.open(null);
    }

    @Override
    public void openFile() {
        window.open(dialogs.open(windows.settings().folder()));
    }

    @Override
    public void openAddress() {
        String address = dialogs.address("");
        if (address != null) window.open(address);
    }

    @Override
    public void paste() {
        List<String> found = Dropped.locations(
                Toolkit.getDefaultToolkit().getSystemClipboard().getContents(null));
        if (found.isEmpty()) window.note("There is neither an address nor a file to paste; copy one first.", true);
        else window.open(found);
    }

    @Override
    public void save(Saving.What what) {
        saving.save(what, window.run(), window.side().detail().shown(), window::facts);
    }

    @Override
    public void savePicture() {
        saving.savePicture(window.run().address(), window.canvas());
    }

    @Override
    public void closeWindow() {
        window.frame().dispose();
    }

    @Override
    public void quit() {
        windows.closeAll();
    }

    @Override
    public void showAll() {
        window.canvas().resetCamera();
    }

    @Override
    public void shade(Shading shading) {
        window.style(s -> s.withShading(shading));
    }

    @Override
    public void toggleWireframe() {
        window.style(s -> s.withWireframe(!s.wireframe()));
    }

    @Override
    public void toggleSidePanel() {
        boolean shown = !window.side().component().isVisible();
        window.setSidePanel(shown);
        windows.settings().setPanelShown(shown);
    }

    @Override
    public void toggleDark() {
        windows.toggleDark();
    }

    @Override
    public void moreDetail() {
        window.ask(() -> window.run().moreDetail());
    }

    @Override
    public void original() {
        window.ask(() -> window.run().original());
    }

    @Override
    public void stop() {
        if (window.run() != null) window.run().stop();
    }

    @Override
    public void tryNow() {
        if (window.run() != null) window.run().tryNow();
    }

    @Override
    public void reload() {
        if (window.run() != null) window.begin(window.run().address(), false);
    }

    @Override
    public void step(boolean finer) {
        window.side().detail().step(finer);
    }

    @Override
    public void help() {
        dialogs.tell("Keys and mouse", HelpWords.KEYS);
    }

    @Override
    public void about() {
        dialogs.tell("About jSM", HelpWords.about());
    }
}
