package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.awt.image.BufferedImage;
import org.jsmesh.desktop.gpu.GpuPicture;

/**
 * Draws scenes with OpenGL 3.3 core into whatever framebuffer is bound. All methods are called on the thread that holds
 * the context. Every binding is undone, because Swing's own OpenGL needs that.
 */
public final class SceneRenderer {
    private final GpuGround ground;
    private final SurfacePass surfaces;
    private final LiveScene live;
    private GpuScene streamed;
    private GpuScene guest; // in the place of the streamed one, or null
    private ErrorMap errors;
    private GpuScene measured; // the same errors on the graphics card, once they are drawn

    /** For whole scenes. */
    public SceneRenderer(GL3 gl) {
        this(gl, new LiveScene());
    }

    /** @param live of which all that is there is brought to the graphics card */
    public SceneRenderer(GL3 gl, LiveScene live) {
        this(gl, live, Layers.areOffered(gl));
    }

    /** @param hasLayers false sorts faces as for a graphics card that cannot look at single samples */
    SceneRenderer(GL3 gl, LiveScene live, boolean hasLayers) {
        ground = new GpuGround(gl);
        surfaces = new SurfacePass(gl, hasLayers ? new Layers(gl) : null);
        this.live = live;
        streamed = new GpuScene(gl, live.shown());
    }

    /** Shows a whole scene, in the place of one that is refined. */
    public void upload(GL3 gl, Scene scene) {
        showLive(gl);
        guest = new GpuScene(gl, new ShownScene(scene));
    }

    /** Shows the scene that is refined. */
    public void showLive(GL3 gl) {
        if (guest != null) guest.dispose(gl);
        guest = null;
    }

    /** What is drawn with {@link Shading#ERROR}; null for a mesh that differs from the newest one nowhere. */
    public void show(GL3 gl, ErrorMap map) {
        errors = map;
        if (measured != null) measured.dispose(gl);
        measured = null;
    }

    /**
     * Brings the next part of a step to the graphics card.
     *
     * @param bytes at most; a step that nothing of the picture outlasts comes at once
     * @return whether the picture is another now
     */
    public boolean advance(GL3 gl, long bytes) {
        if (live.beginsAnother()) {
            streamed.dispose(gl);
            streamed = new GpuScene(gl, new ShownScene());
        }
        boolean isOther = live.advance(gl, streamed.mesh, bytes);
        if (isOther) streamed.changed(live.shown());
        return isOther;
    }

    /**
     * @param camera may be null before the first scene
     * @param background false leaves pixels without surface transparent; colours are premultiplied with opacity
     */
    public void draw(GL3 gl, Camera camera, int width, int height, boolean background, DrawStyle style) {
        gl.glViewport(0, 0, width, height);
        gl.glClearColor(0, 0, 0, 0);
        gl.glDepthMask(true);
        gl.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT);
        if (background) ground.drawBackdrop(gl);
        GpuScene scene = drawn(gl, style);
        if (camera != null && !scene.shown().isEmpty()) {
            // No part of the model is below the ground, so it hides the shadow wherever it is.
            boolean isShaded = background && style.shading() != Shading.NORMALS;
            if (isShaded) ground.drawShadow(gl, light().shown().shadow, camera, width, height);
            SurfacePass.Eye eye = new SurfacePass.Eye(camera.view(), camera.projection(width, height), camera.eye());
            surfaces.draw(gl, scene, step(scene), eye, known(style), most(style));
        }
        gl.glUseProgram(0);
        gl.glBindVertexArray(0);
    }

    /** Materials where nobody knows in which level faces came. */
    private DrawStyle known(DrawStyle style) {
        boolean isKnown = style.shading() != Shading.LEVELS || light().shown().levels().length > 0;
        return isKnown ? style : style.withShading(Shading.MATERIALS);
    }

    /** What the light of the picture falls on. */
    private GpuScene light() {
        return guest != null ? guest : streamed;
    }

    private GpuScene drawn(GL3 gl, DrawStyle style) {
        if (style.shading() != Shading.ERROR || errors == null) return light();
        if (measured == null) measured = new GpuScene(gl, new ShownScene(errors));
        return measured;
    }

    private int step(GpuScene scene) {
        return scene == streamed ? live.unfinished() : -1;
    }

    private double most(DrawStyle style) {
        if (style.shading() == Shading.LEVELS) return light().shown().lastLevel();
        return errors == null ? 0 : errors.farthest();
    }

    /**
     * Finds what lies beneath a place of the picture.
     *
     * @param across from −1 at the left edge to 1 at the right one
     * @param along from −1 at the lower edge to 1 at the upper one
     * @return a point in unit space, or null where there is none of the model
     */
    public double[] pick(GL3 gl, Camera camera, int width, int height, double across, double along) {
        GpuScene scene = light();
        if (scene.shown().isEmpty()) return null;
        return DepthPick.at(gl, camera, width, height, across, along, projection -> {
            SurfacePass.Eye eye = new SurfacePass.Eye(camera.view(), projection, camera.eye());
            surfaces.drawDepth(gl, scene, step(scene), eye);
        });
    }

    /**
     * Draws beside the picture on the screen.
     *
     * @return a picture of type ARGB
     * @throws IllegalArgumentException when the graphics card has no pictures of this size
     */
    public BufferedImage picture(GL3 gl, Camera camera, int width, int height, boolean background, DrawStyle style) {
        return GpuPicture.of(gl, width, height, () -> draw(gl, camera, width, height, background, style));
    }

    public void dispose(GL3 gl) {
        show(gl, null);
        showLive(gl);
        streamed.dispose(gl);
        surfaces.dispose(gl);
        ground.dispose(gl);
    }
}
