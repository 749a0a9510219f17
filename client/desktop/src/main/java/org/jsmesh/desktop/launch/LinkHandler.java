package org.jsmesh.desktop.launch;

import java.io.IOException;
import java.util.Locale;

/** Tells the system of this user which program opens {@code jsm:} links and {@code .jsm} files. */
public abstract sealed class LinkHandler permits FreedesktopHandler, WindowsHandler, MacHandler {
    /**
     * The way of this system.
     *
     * @return the handler
     */
    public static LinkHandler ofSystem() {
        String system = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        if (system.contains("mac")) return new MacHandler();
        return system.contains("win") ? new WindowsHandler() : FreedesktopHandler.ofUser();
    }

    /**
     * Makes the viewer that runs now the program for links and files.
     *
     * @return what was done, a sentence for people
     * @throws IOException when the system does not take it; the message says why and what to do
     * @throws IllegalStateException when this viewer cannot be started again
     */
    public final String register() throws IOException {
        return register(StartCommand.current());
    }

    abstract String register(StartCommand command) throws IOException;

    /**
     * Takes that back. Where nothing was registered, nothing happens.
     *
     * @return what was done, a sentence for people
     * @throws IOException as by {@link #register()}
     */
    public abstract String unregister() throws IOException;
}
