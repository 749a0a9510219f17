package org.jsmesh.desktop;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLAutoDrawable;
import com.jogamp.opengl.GLContext;
import com.jogamp.opengl.GLEventListener;
import com.jogamp.opengl.GLProfile;
import com.jogamp.opengl.awt.GLCanvas;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import javax.swing.Timer;
import org.jsmesh.desktop.draw.Camera;
import org.jsmesh.desktop.draw.DrawStyle;
import org.jsmesh.desktop.draw.ErrorMap;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.LiveScene;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.SceneRenderer;
import org.jsmesh.desktop.draw.SceneStep;
import org.jsmesh.desktop.draw.Screenshot;

/** The OpenGL part of the window. Used on the event dispatch thread; draws only when something has changed. */
final class SceneCanvas implements GLEventListener {
    /** What a step may bring to the graphics card between two looks at other events. */
    static final long SLICE_BYTES = 2 << 20;

    private static final int SLICE_MILLIS = 8;

    private final GLCanvas canvas;
    private final Consumer<String> onError;
    private final LiveScene live = new LiveScene();
    private final Timer slices = new Timer(SLICE_MILLIS, e -> slice());
    private SceneRenderer renderer;
    private Scene scene;
    private ErrorMap errors;
    private boolean uploaded;
    private boolean measured; // whether the renderer has the errors
    private Framing framing;
    private Camera camera;
    private boolean moved;
    private boolean refused;
    private DrawStyle style = DrawStyle.defaults();

    /** @param onError hears in words why nothing can be drawn, and null when it can again */
    SceneCanvas(Consumer<String> onError) {
        this.onError = onError;
        canvas = new GLCanvas(Screenshot.capabilities(GLProfile.get(GLProfile.GL3)));
        canvas.setMinimumSize(new Dimension(1, 1));
        canvas.addGLEventListener(this);
    }

    Component component() {
        return canvas;
    }

    /** Shows a whole scene, in the place of the one that is refined; null shows that one again. */
    void show(Scene next) {
        scene = next;
        uploaded = false;
        canvas.repaint();
    }

    /** Refines the scene. */
    void show(SceneStep step) {
        live.take(step);
        slices.start();
    }

    /** Whether the next part of a step follows by itself. */
    boolean isRefining() {
        return slices.isRunning();
    }

    /** Whether all steps are shown. */
    boolean isResting() {
        return live.isResting();
    }

    /** Sets what is drawn with {@code Shading.ERROR}; null for a mesh that is the newest one. */
    void show(ErrorMap map) {
        errors = map;
        measured = false;
        canvas.repaint();
    }

    /** The last level of the model, the bright end of the colours of {@code Shading.LEVELS}. */
    int lastLevel() {
        return live.lastLevel();
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

    /** Where the eye is; null before the first picture. */
    Camera camera() {
        return camera;
    }

    /** Width through height of the picture. */
    double aspect() {
        return (double) canvas.getSurfaceWidth() / Math.max(1, canvas.getSurfaceHeight());
    }

    /** Of the picture, which has more pixels than the component has units where the screen is fine. */
    PictureSize size() {
        return new PictureSize(canvas.getSurfaceWidth(), canvas.getSurfaceHeight());
    }

    /** How long the model's diagonal is where it is nearest to the eye; NaN before the first picture. */
    double diagonalPixels() {
        return camera == null ? Double.NaN : camera.diagonalPixels(canvas.getSurfaceHeight());
    }

    void move(UnaryOperator<Camera> movement) {
        if (camera == null) return;
        camera = movement.apply(camera);
        moved = true;
        canvas.repaint();
    }

    /**
     * Finds what lies beneath a place of the picture, each from −1 at the left or lower edge to 1.
     *
     * @return a point of the model in unit space, or null where there is none
     */
    double[] pick(double across, double along) {
        if (camera == null) return null;
        int width = canvas.getSurfaceWidth();
        int height = canvas.getSurfaceHeight();
        return withContext(gl -> renderer.pick(gl, camera, width, height, across, along));
    }

    /**
     * What is shown, at any size.
     *
     * @param background false leaves pixels without surface transparent
     * @return a picture of type ARGB; null when nothing can be drawn
     * @throws IllegalArgumentException when the graphics card has no pictures of this size
     */
    BufferedImage picture(int width, int height, boolean background) {
        Camera from = moved || framing == null ? camera : Camera.framing(framing, width, height);
        return withContext(gl -> {
            update(gl);
            return renderer.picture(gl, from, width, height, background, style);
        });
    }

    /** Brings the next part of a step to the graphics card, without drawing. */
    private void slice() {
        Boolean isOther = withContext(gl -> renderer.advance(gl, SLICE_BYTES));
        if (Boolean.TRUE.equals(isOther)) canvas.repaint();
        // Steps wait for a context, which goes on with them.
        if (renderer == null || live.isResting()) slices.stop();
    }

    /** Null where nothing can be drawn now. */
    private <T> T withContext(Function<GL3, T> work) {
        GLContext context = canvas.getContext();
        if (renderer == null || context == null || context.makeCurrent() == GLContext.CONTEXT_NOT_CURRENT) return null;
        try {
            return work.apply(context.getGL().getGL3());
        } finally {
            context.release();
        }
    }

    private void update(GL3 gl) {
        if (!uploaded && scene == null) renderer.showLive(gl);
        else if (!uploaded) renderer.upload(gl, scene);
        if (!measured) renderer.show(gl, errors);
        uploaded = true;
        measured = true;
    }

    @Override
    public void init(GLAutoDrawable drawable) {
        uploaded = false;
        measured = false;
        try {
            renderer = new SceneRenderer(drawable.getGL().getGL3(), live);
            if (!live.isResting()) slices.start();
            if (refused) onError.accept(null);
            refused = false;
        } catch (RuntimeException e) {
            // If it were thrown on, JOGL's own thread would print a stack trace and the window would stay empty.
            renderer = null;
            refused = true;
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
        update(gl);
        renderer.draw(gl, camera, width, height, true, style);
    }

    @Override
    public void dispose(GLAutoDrawable drawable) {
        slices.stop();
        if (renderer != null) renderer.dispose(drawable.getGL().getGL3());
        renderer = null;
    }
}
