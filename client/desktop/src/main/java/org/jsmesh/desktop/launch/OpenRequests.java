package org.jsmesh.desktop.launch;

import java.awt.Desktop;
import java.util.function.Consumer;

/** Links and files that the system hands to a viewer that runs already. macOS hands them over in no other way. */
public final class OpenRequests {
    private OpenRequests() {}

    /**
     * Hears of them from now on, and of what came before. Does nothing where the system starts a viewer for each.
     *
     * @param open takes a link or a path, on the event dispatch thread
     */
    public static void listen(Consumer<String> open) {
        if (!Desktop.isDesktopSupported()) return;
        Desktop desktop = Desktop.getDesktop();
        if (desktop.isSupported(Desktop.Action.APP_OPEN_URI))
            desktop.setOpenURIHandler(event -> open.accept(event.getURI().toString()));
        if (desktop.isSupported(Desktop.Action.APP_OPEN_FILE))
            desktop.setOpenFileHandler(event -> event.getFiles().forEach(file -> open.accept(file.getPath())));
    }
}
