package org.jsmesh.desktop;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Toolkit;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JFrame;
import javax.swing.WindowConstants;

/** Puts the parts of a window into its frame. */
final class WindowFrame {
    private WindowFrame() {}

    /** Shows the frame as large as its parts want and the screen allows. */
    static void show(JFrame frame, Component centre, Component side, Component status, Runnable onClosed) {
        frame.add(centre, BorderLayout.CENTER);
        frame.add(side, BorderLayout.LINE_END);
        frame.add(status, BorderLayout.SOUTH);
        frame.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent e) {
                onClosed.run();
            }
        });
        frame.setIconImages(WindowIcon.sizes());
        frame.pack();
        Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();
        frame.setSize(Math.min(frame.getWidth(), screen.width), Math.min(frame.getHeight(), screen.height));
        frame.setLocationByPlatform(true);
        frame.setVisible(true);
    }
}
