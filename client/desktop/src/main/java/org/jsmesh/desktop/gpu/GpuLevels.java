package org.jsmesh.desktop.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;

/** The levels of triangles on the graphics card. Used on the thread that holds the context. */
public final class GpuLevels {
    private final int[] buffer = new int[1];
    private final int[] texture = new int[1];

    public GpuLevels(GL3 gl) {
        gl.glGenBuffers(1, buffer, 0);
        gl.glGenTextures(1, texture, 0);
    }

    public void upload(GL3 gl, byte[] levels) {
        gl.glBindBuffer(GL2ES3.GL_TEXTURE_BUFFER, buffer[0]);
        gl.glBufferData(GL2ES3.GL_TEXTURE_BUFFER, levels.length, ByteBuffer.wrap(levels), GL.GL_DYNAMIC_DRAW);
        gl.glBindBuffer(GL2ES3.GL_TEXTURE_BUFFER, 0);
    }

    public void bind(GL3 gl, int unit) {
        gl.glActiveTexture(GL.GL_TEXTURE0 + unit);
        gl.glBindTexture(GL2ES3.GL_TEXTURE_BUFFER, texture[0]);
        gl.glTexBuffer(GL2ES3.GL_TEXTURE_BUFFER, GL.GL_R8, buffer[0]);
        gl.glActiveTexture(GL.GL_TEXTURE0);
    }

    public static void unbind(GL3 gl, int unit) {
        gl.glActiveTexture(GL.GL_TEXTURE0 + unit);
        gl.glBindTexture(GL2ES3.GL_TEXTURE_BUFFER, 0);
        gl.glActiveTexture(GL.GL_TEXTURE0);
    }

    public void dispose(GL3 gl) {
        gl.glDeleteTextures(1, texture, 0);
        gl.glDeleteBuffers(1, buffer, 0);
    }
}
