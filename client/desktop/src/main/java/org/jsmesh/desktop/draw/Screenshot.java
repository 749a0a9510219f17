package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLOffscreenAutoDrawable;
import com.jogamp.opengl.GLProfile;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;
import org.jsmesh.desktop.gpu.GpuPicture;

/** Draws a scene without a window. */
public final class Screenshot {
    private Screenshot() {}

    /**
     * @param background false gives a picture with transparent surroundings
     * @return a picture of type ARGB
     * @throws com.jogamp.opengl.GLException when this machine offers no OpenGL 3 or no display
     */
    public static BufferedImage take(Scene scene, Camera camera, int width, int height, boolean background) {
        return take(scene, camera, width, height, background, DrawStyle.defaults());
    }

    /**
     * The same in another style.
     *
     * @return a picture of type ARGB
     * @throws com.jogamp.opengl.GLException when this machine offers no OpenGL 3 or no display
     */
    public static BufferedImage take(
            Scene scene, Camera camera, int width, int height, boolean background, DrawStyle style) {
        return draw(width, height, gl -> {
            SceneRenderer renderer = new SceneRenderer(gl);
            renderer.upload(gl, scene);
            renderer.draw(gl, camera, width, height, background, style);
        });
    }

    /** What is drawn into a framebuffer without a window. */
    static BufferedImage draw(int width, int height, Consumer<GL3> work) {
        GLProfile profile = GLProfile.get(GLProfile.GL3);
        GLOffscreenAutoDrawable drawable = GLDrawableFactory.getFactory(profile)
                .createOffscreenAutoDrawable(null, capabilities(profile), null, width, height);
        int[] pixels = new int[width * height];
        try {
            drawable.display(); // allocates the framebuffer
            drawable.invoke(true, d -> {
                GL3 gl = d.getGL().getGL3();
                work.accept(gl);
                return true;
            });
            drawable.invoke(true, d -> {
                GpuPicture.read(d.getGL().getGL3(), width, height, pixels);
                return true;
            });
        } finally {
            drawable.destroy();
        }
        return GpuPicture.upright(pixels, width, height);
    }

    /** The same for the window: true colour with opacity, a fine depth buffer, four samples per pixel. */
    public static GLCapabilities capabilities(GLProfile profile) {
        GLCapabilities wanted = new GLCapabilities(profile);
        wanted.setAlphaBits(8);
        wanted.setDepthBits(24);
        wanted.setSampleBuffers(true);
        wanted.setNumSamples(4);
        return wanted;
    }
}
