package org.jsmesh.desktop;

import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import javax.swing.SwingUtilities;

/** Brings keys on the picture, which the system draws, to the menus of Swing. Comes after what moves the camera. */
final class MenuKeys extends KeyAdapter {
    @Override
    public void keyPressed(KeyEvent e) {
        if (!e.isConsumed() && SwingUtilities.processKeyBindings(e)) e.consume();
    }
}
