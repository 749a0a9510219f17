package org.jsmesh.desktop;

import org.jsmesh.desktop.draw.Shading;

/** What the actions of a window do. On the event dispatch thread; each returns at once. */
interface ViewerCommands {
    void newWindow();

    void openFile();

    void openAddress();

    void paste();

    void save(Saving.What what);

    void savePicture();

    void closeWindow();

    void quit();

    void showAll();

    void shade(Shading shading);

    void toggleWireframe();

    void toggleSidePanel();

    void toggleDark();

    void moreDetail();

    void original();

    void stop();

    void tryNow();

    void reload();

    /** Shows a finer or coarser resolution of what has arrived. */
    void step(boolean finer);

    void help();

    void about();
}
