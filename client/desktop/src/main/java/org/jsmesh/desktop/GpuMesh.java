package org.jsmesh.desktop;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.Buffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import org.jsmesh.display.RenderMesh;

/** A {@link RenderMesh} in buffers of the graphics card. Used on the thread that holds the context. */
final class GpuMesh {
    private static final int POSITION = 0;
    private static final int NORMAL = 1;
    private static final int TEX_COORD = 2;
    private static final int COLOUR = 3;

    private final int[] vertexArray = new int[1];
    private final int[] attributes = new int[4];
    private final int[] elements = new int[1];

    GpuMesh(GL3 gl) {
        gl.glGenVertexArrays(1, vertexArray, 0);
        gl.glGenBuffers(attributes.length, attributes, 0);
        gl.glGenBuffers(1, elements, 0);
    }

    /** Replaces all buffers. A mesh of 48 MB takes about 20 ms, so nothing is patched in place. */
    void upload(GL3 gl, RenderMesh mesh) {
        gl.glBindVertexArray(vertexArray[0]);
        attribute(gl, POSITION, FloatBuffer.wrap(mesh.positions()), 3, GL.GL_FLOAT, 12);
        attribute(gl, NORMAL, FloatBuffer.wrap(mesh.normals()), 3, GL.GL_FLOAT, 12);
        attribute(gl, TEX_COORD, FloatBuffer.wrap(mesh.textureCoordinates()), 2, GL.GL_FLOAT, 8);
        // Red is the lowest byte, and so the first one: every machine that JOGL has natives for is little-endian.
        attribute(gl, COLOUR, IntBuffer.wrap(mesh.colours()), 3, GL.GL_UNSIGNED_BYTE, 4);
        gl.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, elements[0]);
        gl.glBufferData(
                GL.GL_ELEMENT_ARRAY_BUFFER,
                4L * mesh.indices().length,
                IntBuffer.wrap(mesh.indices()),
                GL.GL_DYNAMIC_DRAW);
        gl.glBindVertexArray(0);
        gl.glBindBuffer(GL.GL_ARRAY_BUFFER, 0);
    }

    private void attribute(GL3 gl, int location, Buffer values, int components, int type, int stride) {
        if (!values.hasRemaining()) {
            gl.glDisableVertexAttribArray(location);
            return;
        }
        gl.glBindBuffer(GL.GL_ARRAY_BUFFER, attributes[location]);
        gl.glBufferData(GL.GL_ARRAY_BUFFER, 4L * values.remaining(), values, GL.GL_DYNAMIC_DRAW);
        gl.glEnableVertexAttribArray(location);
        gl.glVertexAttribPointer(location, components, type, type != GL.GL_FLOAT, stride, 0L);
    }

    void bind(GL3 gl) {
        gl.glBindVertexArray(vertexArray[0]);
        // Values for missing arrays: texture corner, white.
        gl.glVertexAttrib2f(TEX_COORD, 0, 0);
        gl.glVertexAttrib3f(COLOUR, 1, 1, 1);
    }

    /** Draws the faces of a group. */
    void draw(GL3 gl, int firstIndex, int indices) {
        gl.glDrawElements(GL.GL_TRIANGLES, indices, GL.GL_UNSIGNED_INT, 4L * firstIndex);
    }

    void dispose(GL3 gl) {
        gl.glDeleteVertexArrays(1, vertexArray, 0);
        gl.glDeleteBuffers(attributes.length, attributes, 0);
        gl.glDeleteBuffers(1, elements, 0);
    }
}
