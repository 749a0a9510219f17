package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2GL3;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLCapabilities;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLOffscreenAutoDrawable;
import com.jogamp.opengl.GLProfile;
import java.awt.image.BufferedImage;
import java.nio.IntBuffer;

/** Draws a scene without a window. */
public final class Screenshot {
    private Screenshot() {}

    /**
     * @param background false gives a picture with transparent surroundings
     * @return a picture of type ARGB
     * @throws com.jogamp.opengl.GLException when this machine offers no OpenGL 3 or no display
     */
    public static BufferedImage take(Scene scene, Camera camera, int width, int height, boolean background) {
        GLProfile profile = GLProfile.get(GLProfile.GL3);
        GLOffscreenAutoDrawable drawable = GLDrawableFactory.getFactory(profile)
                .createOffscreenAutoDrawable(null, capabilities(profile), null, width, height);
        int[] pixels = new int[width * height];
        try {
            drawable.display(); // allocates the framebuffer
            drawable.invoke(true, d -> {
                GL3 gl = d.getGL().getGL3();
                SceneRenderer renderer = new SceneRenderer(gl);
                renderer.upload(gl, scene);
                renderer.draw(gl, camera, width, height, background, false);
                return true;
            });
            drawable.invoke(true, d -> {
                read(d.getGL().getGL3(), width, height, pixels);
                return true;
            });
        } finally {
            drawable.destroy();
        }
        return picture(pixels, width, height);
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

    private static void read(GL3 gl, int width, int height, int[] argb) {
        gl.glPixelStorei(GL.GL_PACK_ALIGNMENT, 4);
        gl.glReadPixels(0, 0, width, height, GL.GL_BGRA, GL2GL3.GL_UNSIGNED_INT_8_8_8_8_REV, IntBuffer.wrap(argb));
    }

    /** Reverses the rows and divides the colours by their opacity. */
    private static BufferedImage picture(int[] pixels, int width, int height) {
        BufferedImage premultiplied = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB_PRE);
        for (int y = 0; y < height; y++) {
            premultiplied.getRaster().setDataElements(0, height - 1 - y, width, 1, row(pixels, y, width));
        }
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        picture.getGraphics().drawImage(premultiplied, 0, 0, null);
        return picture;
    }

    private static int[] row(int[] pixels, int y, int width) {
        int[] row = new int[width];
        System.arraycopy(pixels, y * width, row, 0, width);
        return row;
    }
}
