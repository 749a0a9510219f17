package org.jsmesh.desktop;

import com.jogamp.opengl.GLException;
import java.nio.file.Path;

/** Joins a window and a session. */
final class WindowRun implements ViewerWindow.Requests {
    private final String location;
    private final int waitMillis;
    private final PictureSize size;
    private final Path cache;
    private final Runnable onClose;
    private ViewerSession session;

    /**
     * @param cache folder in which archives are kept, or null
     * @param onClose called when the window has been closed
     */
    WindowRun(String location, int waitMillis, PictureSize size, Path cache, Runnable onClose) {
        this.location = location;
        this.waitMillis = waitMillis;
        this.size = size;
        this.cache = cache;
        this.onClose = onClose;
    }

    /**
     * On the event dispatch thread.
     *
     * @param original true loads everything at once
     * @throws ViewerException when there is no OpenGL
     * @throws IllegalArgumentException when the location is not valid
     */
    void open(boolean original) {
        ViewerWindow window;
        try {
            window = new ViewerWindow(title(location), WaitConverter.words(waitMillis), size, this);
        } catch (GLException | UnsatisfiedLinkError e) {
            throw new ViewerException(ScreenshotRun.noOpenGl(e), e);
        }
        session = new ViewerSession(location, cache, window);
        if (original) original();
        else moreDetail();
    }

    /** The model's name: the last part of a path that is neither a manifest's file name nor a hash. */
    static String title(String location) {
        String path = location.replaceAll("[?#].*$", "").replaceAll("/(manifest\\.json|[0-9a-f]{64}\\.jsm)$", "");
        String name = path.replaceAll("[/\\\\]+$", "").replaceAll(".*[/\\\\]", "");
        return name.isEmpty() ? location : name;
    }

    @Override
    public void moreDetail() {
        session.refine(waitMillis);
    }

    @Override
    public void original() {
        session.complete();
    }

    @Override
    public void close() {
        if (session != null) session.close();
        onClose.run();
    }
}
