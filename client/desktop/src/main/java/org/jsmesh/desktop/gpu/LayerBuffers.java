package org.jsmesh.desktop.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;

/**
 * Framebuffers for layers of translucent surfaces, as large as the picture. Used on the thread that holds the context.
 */
public final class LayerBuffers {
    private static final int SAMPLES = 4;
    private static final int DEPTHS = 3;

    /** Pixels across. */
    public final int width;

    /** Pixels from top to bottom. */
    public final int height;

    /**
     * Colours of all layers with the depths of one or of the opaque surfaces each; the last one is the resolved one.
     */
    private final int[] framebuffers = new int[DEPTHS + 1];

    private final int[] textures = new int[DEPTHS + 2];

    /** Makes them for pictures of one size in pixels. */
    public LayerBuffers(GL3 gl, int width, int height) {
        this.width = width;
        this.height = height;
        gl.glGenFramebuffers(framebuffers.length, framebuffers, 0);
        gl.glGenTextures(textures.length, textures, 0);
        int colours = textures[DEPTHS];
        multisampled(gl, colours, GL.GL_RGBA16F);
        for (int i = 0; i < DEPTHS; i++) {
            multisampled(gl, textures[i], GL3.GL_DEPTH_COMPONENT32F);
            gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffers[i]);
            attach(gl, GL.GL_COLOR_ATTACHMENT0, GL3.GL_TEXTURE_2D_MULTISAMPLE, colours);
            attach(gl, GL.GL_DEPTH_ATTACHMENT, GL3.GL_TEXTURE_2D_MULTISAMPLE, textures[i]);
        }
        gl.glBindTexture(GL.GL_TEXTURE_2D, textures[DEPTHS + 1]);
        gl.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGBA16F, width, height, 0, GL.GL_RGBA, GL.GL_FLOAT, null);
        for (int filter : new int[] {GL.GL_TEXTURE_MIN_FILTER, GL.GL_TEXTURE_MAG_FILTER})
            gl.glTexParameteri(GL.GL_TEXTURE_2D, filter, GL.GL_NEAREST);
        gl.glBindTexture(GL.GL_TEXTURE_2D, 0);
        gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffers[DEPTHS]);
        attach(gl, GL.GL_COLOR_ATTACHMENT0, GL.GL_TEXTURE_2D, textures[DEPTHS + 1]);
    }

    private void multisampled(GL3 gl, int texture, int format) {
        gl.glBindTexture(GL3.GL_TEXTURE_2D_MULTISAMPLE, texture);
        gl.glTexImage2DMultisample(GL3.GL_TEXTURE_2D_MULTISAMPLE, SAMPLES, format, width, height, true);
        gl.glBindTexture(GL3.GL_TEXTURE_2D_MULTISAMPLE, 0);
    }

    private static void attach(GL3 gl, int place, int target, int texture) {
        gl.glFramebufferTexture2D(GL.GL_FRAMEBUFFER, place, target, texture, 0);
    }

    /** Draws go to the depths of this number from now on, 0 to 2, and to the colours. */
    public void bind(GL3 gl, int depths) {
        gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, framebuffers[depths]);
    }

    /** Binds the depths of a number, 0 to 2, to a texture unit. */
    public void bindDepths(GL3 gl, int depths, int unit) {
        gl.glActiveTexture(GL.GL_TEXTURE0 + unit);
        gl.glBindTexture(GL3.GL_TEXTURE_2D_MULTISAMPLE, textures[depths]);
        gl.glActiveTexture(GL.GL_TEXTURE0);
    }

    /** Leaves no depths bound to a texture unit. */
    public static void unbindDepths(GL3 gl, int unit) {
        gl.glActiveTexture(GL.GL_TEXTURE0 + unit);
        gl.glBindTexture(GL3.GL_TEXTURE_2D_MULTISAMPLE, 0);
        gl.glActiveTexture(GL.GL_TEXTURE0);
    }

    /** Leaves the colours, one for each pixel, as the texture of unit 0. */
    public void resolve(GL3 gl) {
        gl.glBindFramebuffer(GL2ES3.GL_READ_FRAMEBUFFER, framebuffers[0]);
        gl.glBindFramebuffer(GL2ES3.GL_DRAW_FRAMEBUFFER, framebuffers[DEPTHS]);
        gl.glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL.GL_COLOR_BUFFER_BIT, GL.GL_NEAREST);
        gl.glBindTexture(GL.GL_TEXTURE_2D, textures[DEPTHS + 1]);
        gl.glBindSampler(0, 0);
    }

    /** Gives them back to the card. */
    public void dispose(GL3 gl) {
        gl.glDeleteFramebuffers(framebuffers.length, framebuffers, 0);
        gl.glDeleteTextures(textures.length, textures, 0);
    }
}
