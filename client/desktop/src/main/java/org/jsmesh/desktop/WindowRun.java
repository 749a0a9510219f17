package org.jsmesh.desktop;

import com.jogamp.opengl.GLException;

/** Joins a window and a session. */
final class WindowRun implements ViewerWindow.Requests {
    private final String location;
    private final int waitMillis;
    private final PictureSize size;
    private ViewerSession session;

    WindowRun(String location, int waitMillis, PictureSize size) {
        this.location = location;
        this.waitMillis = waitMillis;
        this.size = size;
    }

    /**
     * On the event dispatch thread. The window's end is the program's end.
     *
     * @param original true loads everything at once
     * @throws ViewerException when there is no OpenGL
     * @throws IllegalArgumentException when the location is none
     */
    void open(boolean original) {
        String name = location.replaceAll("/manifest\\.json$", "")
                .replaceAll("[/\\\\]+$", "")
                .replaceAll(".*[/\\\\]", "");
        ViewerWindow window;
        try {
            window = new ViewerWindow(name, WaitConverter.words(waitMillis), size, this);
        } catch (GLException | UnsatisfiedLinkError e) {
            throw new ViewerException(ScreenshotRun.noOpenGl(e), e);
        }
        session = new ViewerSession(location, window);
        if (original) original();
        else moreDetail();
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
        System.exit(0);
    }
}
