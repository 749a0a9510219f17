package org.jsmesh.desktop;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.ToolTipManager;
import javax.swing.WindowConstants;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.SceneStep;

/**
 * The window: the picture above, {@link StatusBar} below. Made on the event dispatch thread;
 * {@link SessionView.Display} methods may be called from any thread.
 */
final class ViewerWindow implements SessionView.Display {
    /** The user's wishes to the session; each call returns at once. */
    interface Requests {
        void moreDetail();

        void original();

        void close();
    }

    private final JFrame frame;
    private final SceneCanvas canvas;
    private final StatusBar status;
    private final Requests requests;
    private ViewState state = ViewState.START;

    /**
     * @param title of the model
     * @param waitWords the wait of a round, for people
     */
    ViewerWindow(String title, String waitWords, PictureSize size, Requests requests) {
        this.requests = requests;
        frame = new JFrame(title + " – jSM");
        // The system draws the canvas above Swing's light-weight windows.
        ToolTipManager.sharedInstance().setLightWeightPopupEnabled(false);
        canvas = new SceneCanvas(words -> show(state.with(ViewState.Phase.ERROR).withMessage(words)));
        status = new StatusBar(waitWords, this::moreDetail, this::original);
        CameraControls.install(canvas);
        canvas.component().addKeyListener(new ActionKeys());
        canvas.component().setPreferredSize(new Dimension(size.width(), size.height()));
        frame.add(canvas.component(), BorderLayout.CENTER);
        frame.add(status.component(), BorderLayout.SOUTH);
        frame.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent e) {
                requests.close();
            }
        });
        frame.pack();
        frame.setLocationByPlatform(true);
        frame.setVisible(true);
        canvas.component().requestFocusInWindow();
    }

    JFrame frame() {
        return frame;
    }

    @Override
    public void frame(Framing framing) {
        SwingUtilities.invokeLater(() -> canvas.frame(framing));
    }

    @Override
    public void show(Scene scene) {
        SwingUtilities.invokeLater(() -> canvas.show(scene));
    }

    @Override
    public boolean isLive() {
        return true;
    }

    @Override
    public void show(SceneStep step) {
        SwingUtilities.invokeLater(() -> canvas.show(step));
    }

    @Override
    public void show(ViewState next) {
        SwingUtilities.invokeLater(() -> {
            state = next;
            status.show(next);
        });
    }

    private void moreDetail() {
        ask(requests::moreDetail);
    }

    private void original() {
        ask(requests::original);
    }

    private void ask(Runnable request) {
        if (!state.canRefine()) return;
        state = state.with(ViewState.Phase.REFINING).withMessage(null);
        status.show(state);
        request.run();
    }

    private final class ActionKeys extends KeyAdapter {
        @Override
        public void keyPressed(KeyEvent e) {
            switch (e.getKeyCode()) {
                case KeyEvent.VK_SPACE -> moreDetail();
                case KeyEvent.VK_O -> original();
                default -> {
                    // The camera's.
                }
            }
        }
    }
}
