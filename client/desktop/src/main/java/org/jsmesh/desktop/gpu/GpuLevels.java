package org.jsmesh.desktop.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;

/** The levels of triangles on the graphics card. Used on the thread that holds the context. */
public final class GpuLevels {
    private final int[] buffer = new int[1];
    private final int[] texture = new int[1];

    /** Makes an empty buffer of levels. */
    public GpuLevels(GL3 gl) {
        gl.glGenBuffers(1, buffer, 0);
        gl.glGenTextures(1, texture, 0);
    }

    /**
     * Replaces all levels.
     *
     * @param levels by the place of the triangle, 0 to 255
     */
    public void upload(GL3 gl, byte[] levels) {
        gl.glBindBuffer(GL2ES3.GL_TEXTURE_BUFFER, buffer[0]);
        gl.glBufferData(GL2ES3.GL_TEXTURE_BUFFER, levels.length, ByteBuffer.wrap(levels), GL.GL_DYNAMIC_DRAW);
        gl.glBindBuffer(GL2ES3.GL_TEXTURE_BUFFER, 0);
    }

    /** Binds them to a texture unit, for a sampler of a buffer. */
    public void bind(GL3 gl, int unit) {
        gl.glActiveTexture(GL.GL_TEXTURE0 + unit);
        gl.glBindTexture(GL2ES3.GL_TEXTURE_BUFFER, texture[0]);
        gl.glTexBuffer(GL2ES3.GL_TEXTURE_BUFFER, GL.GL_R8, buffer[0]);
        gl.glActiveTexture(GL.GL_TEXTURE0);
    }

    /** Leaves no levels bound to a texture unit. */
    public static void unbind(GL3 gl, int unit) {
        gl.glActiveTexture(GL.GL_TEXTURE0 + unit);
        gl.glBindTexture(GL2ES3.GL_TEXTURE_BUFFER, 0);
        gl.glActiveTexture(GL.GL_TEXTURE0);
    }

    /** Gives them back to the card. */
    public void dispose(GL3 gl) {
        gl.glDeleteTextures(1, texture, 0);
        gl.glDeleteBuffers(1, buffer, 0);
    }
}
