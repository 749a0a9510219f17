package org.jsmesh.desktop;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLAutoDrawable;
import com.jogamp.opengl.GLEventListener;
import com.jogamp.opengl.GLProfile;
import com.jogamp.opengl.awt.GLCanvas;
import java.awt.Component;
import java.awt.Dimension;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.jsmesh.desktop.draw.Camera;
import org.jsmesh.desktop.draw.DrawStyle;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.SceneRenderer;
import org.jsmesh.desktop.draw.Screenshot;

/** The OpenGL part of the window. Used on the event dispatch thread; draws only when something has changed. */
final class SceneCanvas implements GLEventListener {
    private final GLCanvas canvas;
    private final Consumer<String> onError;
    private SceneRenderer renderer;
    private Scene scene;
    private boolean uploaded;
    private Framing framing;
    private Camera camera;
    private boolean moved;
    private DrawStyle style = DrawStyle.defaults();

    /** @param onError hears in words why nothing can be drawn */
    SceneCanvas(Consumer<String> onError) {
        this.onError = onError;
        canvas = new GLCanvas(Screenshot.capabilities(GLProfile.get(GLProfile.GL3)));
        canvas.setMinimumSize(new Dimension(1, 1));
        canvas.addGLEventListener(this);
    }

    Component component() {
        return canvas;
    }

    void show(Scene next) {
        scene = next;
        uploaded = false;
        canvas.repaint();
    }

    /** Sets the size of the model and shows all of it. */
    void frame(Framing next) {
        framing = next;
        resetCamera();
    }

    void resetCamera() {
        moved = false;
        camera = null;
        canvas.repaint();
    }

    DrawStyle style() {
        return style;
    }

    /** Draws in another style from now on. */
    void style(DrawStyle next) {
        style = next;
        canvas.repaint();
    }

    void move(UnaryOperator<Camera> movement) {
        if (camera == null) return;
        camera = movement.apply(camera);
        moved = true;
        canvas.repaint();
    }

    @Override
    public void init(GLAutoDrawable drawable) {
        uploaded = false;
        try {
            renderer = new SceneRenderer(drawable.getGL().getGL3());
        } catch (RuntimeException e) {
            // If it were thrown on, JOGL's own thread would print a stack trace and the window would stay empty.
            renderer = null;
            onError.accept(SessionView.words(e));
        }
    }

    @Override
    public void reshape(GLAutoDrawable drawable, int x, int y, int width, int height) {
        // Until the user has moved it, the camera keeps the whole model in the window.
        if (!moved) camera = null;
    }

    @Override
    public void display(GLAutoDrawable drawable) {
        int width = drawable.getSurfaceWidth();
        int height = drawable.getSurfaceHeight();
        if (renderer == null || width == 0 || height == 0) return;
        GL3 gl = drawable.getGL().getGL3();
        if (camera == null && framing != null) camera = Camera.framing(framing, width, height);
        if (!uploaded && scene != null) {
            renderer.upload(gl, scene);
            uploaded = true;
        }
        renderer.draw(gl, camera, width, height, true, style.wireframe());
    }

    @Override
    public void dispose(GLAutoDrawable drawable) {
        if (renderer != null) renderer.dispose(drawable.getGL().getGL3());
        renderer = null;
    }
}
