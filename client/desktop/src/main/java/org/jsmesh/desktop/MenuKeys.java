package org.jsmesh.desktop;

import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import javax.swing.SwingUtilities;

/** Brings keys on the picture, which the system draws, to the menus of Swing. Comes after what moves the camera. */
final class MenuKeys extends KeyAdapter {
    private final Runnable onTaken;

    /** @param onTaken called when a key was for the picture, which may have another style then */
    MenuKeys(Runnable onTaken) {
        this.onTaken = onTaken;
    }

    @Override
    public void keyPressed(KeyEvent e) {
        if (e.isConsumed()) onTaken.run();
        else if (SwingUtilities.processKeyBindings(e)) e.consume();
    }
}
