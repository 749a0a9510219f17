package org.jsmesh.desktop;

import javax.swing.SwingUtilities;

/**
 * Work beside the windows that must come to its end before the program does: a file that is saved, a folder that is
 * removed. Used on the event dispatch thread.
 */
final class Background {
    private final Runnable onIdle;
    private int running;

    /** @param onIdle called when the last work has ended */
    Background(Runnable onIdle) {
        this.onIdle = onIdle;
    }

    /**
     * Begins.
     *
     * @param name of the thread
     * @param work what it hands to the event dispatch thread by {@code invokeLater} belongs to it
     */
    void run(String name, Runnable work) {
        running++;
        Thread thread = new Thread(
                () -> {
                    try {
                        work.run();
                    } finally {
                        SwingUtilities.invokeLater(this::ended);
                    }
                },
                name);
        thread.setDaemon(true);
        thread.start();
    }

    private void ended() {
        running--;
        if (isIdle()) onIdle.run();
    }

    boolean isIdle() {
        return running == 0;
    }
}
