package org.jsmesh.desktop;

import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.swing.SwingUtilities;

/**
 * Moves the camera: drag to orbit, drag with the right or middle button or with Shift to pan, wheel to zoom about what
 * lies beneath the pointer, double click to see the whole model again; arrow keys orbit (with Shift they pan), + and −
 * zoom, F resets. Places are shares of the window, so that it does not matter how many pixels a unit of the pointer
 * has.
 */
final class CameraControls {
    private static final double ZOOM_STEP = 1.1;
    private static final double KEY_ANGLE = Math.toRadians(7.5);
    private static final double KEY_PAN = .05;

    private final SceneCanvas scene;

    private CameraControls(SceneCanvas scene) {
        this.scene = scene;
    }

    static void install(SceneCanvas scene) {
        CameraControls controls = new CameraControls(scene);
        Pointer pointer = controls.new Pointer();
        Component component = scene.component();
        component.addMouseListener(pointer);
        component.addMouseMotionListener(pointer);
        component.addMouseWheelListener(pointer);
        component.addKeyListener(controls.new Keys());
    }

    private final class Pointer extends MouseAdapter {
        private int x;
        private int y;
        private double[] held; // beneath the pointer when it was pressed; null for nothing
        private double[] about; // beneath the pointer when the wheel was first turned there
        private boolean isKnown; // whether that was looked for

        @Override
        public void mousePressed(MouseEvent e) {
            x = e.getX();
            y = e.getY();
            held = isPan(e) ? beneath(e) : null;
            e.getComponent().requestFocusInWindow();
        }

        @Override
        public void mouseClicked(MouseEvent e) {
            isKnown = false;
            if (e.getClickCount() == 2 && SwingUtilities.isLeftMouseButton(e)) scene.resetCamera();
        }

        @Override
        public void mouseDragged(MouseEvent e) {
            double height = Math.max(1, e.getComponent().getHeight());
            double dx = (e.getX() - x) / height;
            double dy = (e.getY() - y) / height;
            x = e.getX();
            y = e.getY();
            isKnown = false;
            // Half a turn for a drag over the height of the window.
            if (isPan(e)) scene.move(c -> c.pan(dx, -dy, held == null ? c.distance() : c.depth(held)));
            else scene.move(c -> c.orbit(-Math.PI * dx, Math.PI * dy));
        }

        @Override
        public void mouseMoved(MouseEvent e) {
            isKnown = false;
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent e) {
            if (!isKnown) about = beneath(e);
            isKnown = true;
            double factor = Math.pow(ZOOM_STEP, e.getPreciseWheelRotation());
            scene.move(c ->
                    c.zoom(factor, about == null ? c.point(across(e), along(e), scene.aspect(), c.distance()) : about));
        }

        private static boolean isPan(MouseEvent e) {
            return e.isShiftDown() || !SwingUtilities.isLeftMouseButton(e);
        }

        private double[] beneath(MouseEvent e) {
            return scene.pick(across(e), along(e));
        }

        private static double across(MouseEvent e) {
            return 2 * (e.getX() + .5) / Math.max(1, e.getComponent().getWidth()) - 1;
        }

        private static double along(MouseEvent e) {
            return 1 - 2 * (e.getY() + .5) / Math.max(1, e.getComponent().getHeight());
        }
    }

    private final class Keys extends KeyAdapter {
        @Override
        public void keyPressed(KeyEvent e) {
            if ((e.getModifiersEx()
                            & (InputEvent.CTRL_DOWN_MASK | InputEvent.ALT_DOWN_MASK | InputEvent.META_DOWN_MASK))
                    != 0) {
                return;
            }
            switch (e.getKeyCode()) {
                case KeyEvent.VK_LEFT -> turn(e, -1, 0);
                case KeyEvent.VK_RIGHT -> turn(e, 1, 0);
                case KeyEvent.VK_UP -> turn(e, 0, 1);
                case KeyEvent.VK_DOWN -> turn(e, 0, -1);
                case KeyEvent.VK_PLUS, KeyEvent.VK_ADD, KeyEvent.VK_EQUALS, KeyEvent.VK_PAGE_UP -> zoom(1 / ZOOM_STEP);
                case KeyEvent.VK_MINUS, KeyEvent.VK_SUBTRACT, KeyEvent.VK_PAGE_DOWN -> zoom(ZOOM_STEP);
                case KeyEvent.VK_F -> scene.resetCamera();
                default -> {
                    return;
                }
            }
            e.consume();
        }

        private void turn(KeyEvent e, int right, int up) {
            if (e.isShiftDown()) scene.move(c -> c.pan(KEY_PAN * right, KEY_PAN * up));
            else scene.move(c -> c.orbit(KEY_ANGLE * right, KEY_ANGLE * up));
        }

        private void zoom(double factor) {
            scene.move(c -> c.zoom(factor));
        }
    }
}
