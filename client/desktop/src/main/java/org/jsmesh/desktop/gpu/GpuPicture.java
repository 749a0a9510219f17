package org.jsmesh.desktop.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL2GL3;
import com.jogamp.opengl.GL3;
import java.awt.image.BufferedImage;
import java.nio.IntBuffer;

/** Draws pictures of any size beside what is on the screen. Used on the thread that holds the context. */
public final class GpuPicture {
    private static final int SAMPLES = 4;

    private GpuPicture() {}

    /**
     * @param draw draws into the framebuffer that is bound
     * @return a picture of type ARGB
     * @throws IllegalArgumentException when the graphics card has no pictures of this size
     */
    public static BufferedImage of(GL3 gl, int width, int height, Runnable draw) {
        int[] most = new int[1];
        gl.glGetIntegerv(GL.GL_MAX_RENDERBUFFER_SIZE, most, 0);
        if (Math.min(width, height) < 1 || Math.max(width, height) > most[0])
            throw new IllegalArgumentException("a picture of " + width + " × " + height
                    + " pixels: this graphics card draws 1 to " + most[0] + " a side; choose a size between");
        int before = gl.getBoundFramebuffer(GL.GL_FRAMEBUFFER);
        int[] framebuffers = new int[2];
        int[] renderbuffers = new int[3];
        gl.glGenFramebuffers(2, framebuffers, 0);
        gl.glGenRenderbuffers(3, renderbuffers, 0);
        gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffers[1]);
        attach(gl, renderbuffers[2], GL.GL_COLOR_ATTACHMENT0, GL.GL_RGBA8, 0, width, height);
        gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffers[0]);
        attach(gl, renderbuffers[0], GL.GL_COLOR_ATTACHMENT0, GL.GL_RGBA8, SAMPLES, width, height);
        attach(gl, renderbuffers[1], GL.GL_DEPTH_ATTACHMENT, GL.GL_DEPTH_COMPONENT24, SAMPLES, width, height);
        int[] pixels = new int[width * height];
        try {
            draw.run();
            gl.glBindFramebuffer(GL2ES3.GL_READ_FRAMEBUFFER, framebuffers[0]);
            gl.glBindFramebuffer(GL2ES3.GL_DRAW_FRAMEBUFFER, framebuffers[1]);
            gl.glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL.GL_COLOR_BUFFER_BIT, GL.GL_NEAREST);
            gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffers[1]);
            read(gl, width, height, pixels);
        } finally {
            gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, before);
            gl.glDeleteFramebuffers(2, framebuffers, 0);
            gl.glDeleteRenderbuffers(3, renderbuffers, 0);
        }
        return upright(pixels, width, height);
    }

    private static void attach(GL3 gl, int name, int place, int format, int samples, int width, int height) {
        gl.glBindRenderbuffer(GL.GL_RENDERBUFFER, name);
        gl.glRenderbufferStorageMultisample(GL.GL_RENDERBUFFER, samples, format, width, height);
        gl.glBindRenderbuffer(GL.GL_RENDERBUFFER, 0);
        gl.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, place, GL.GL_RENDERBUFFER, name);
    }

    /** Reads what is in the framebuffer that is bound, rows from below. */
    public static void read(GL3 gl, int width, int height, int[] argb) {
        gl.glPixelStorei(GL.GL_PACK_ALIGNMENT, 4);
        gl.glReadPixels(0, 0, width, height, GL.GL_BGRA, GL2GL3.GL_UNSIGNED_INT_8_8_8_8_REV, IntBuffer.wrap(argb));
    }

    /** Reverses the rows and divides the colours by their opacity. */
    public static BufferedImage upright(int[] pixels, int width, int height) {
        BufferedImage premultiplied = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB_PRE);
        int[] row = new int[width];
        for (int y = 0; y < height; y++) {
            System.arraycopy(pixels, y * width, row, 0, width);
            premultiplied.getRaster().setDataElements(0, height - 1 - y, width, 1, row);
        }
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        picture.getGraphics().drawImage(premultiplied, 0, 0, null);
        return picture;
    }
}
