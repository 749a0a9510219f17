package org.jsmesh.desktop.draw;

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
    private static final int COLOUR = 2;
    private static final int TANGENT = 3;
    private static final int SET_0 = 4;

    private final int[] vertexArray = new int[1];
    private final int[] attributes = new int[SET_0 + RenderMesh.SETS];
    private final int[] elements = new int[1];

    GpuMesh(GL3 gl) {
        gl.glGenVertexArrays(1, vertexArray, 0);
        gl.glGenBuffers(attributes.length, attributes, 0);
        gl.glGenBuffers(1, elements, 0);
    }

    /** Replaces all buffers. A mesh of 48 MB takes about 20 ms, so nothing is patched in place. */
    void upload(GL3 gl, RenderMesh mesh) {
        gl.glBindVertexArray(vertexArray[0]);
        attribute(gl, POSITION, FloatBuffer.wrap(mesh.positions()), 3, GL.GL_FLOAT);
        attribute(gl, NORMAL, FloatBuffer.wrap(mesh.normals()), 3, GL.GL_FLOAT);
        attribute(gl, TANGENT, FloatBuffer.wrap(mesh.tangents()), 4, GL.GL_FLOAT);
        for (int i = 0; i < RenderMesh.SETS; i++)
            attribute(gl, SET_0 + i, FloatBuffer.wrap(mesh.textureCoordinates()[i]), 2, GL.GL_FLOAT);
        // Red is the lowest byte, and so the first one: every machine that JOGL has natives for is little-endian.
        attribute(gl, COLOUR, IntBuffer.wrap(mesh.colours()), 4, GL.GL_UNSIGNED_BYTE);
        gl.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, elements[0]);
        gl.glBufferData(
                GL.GL_ELEMENT_ARRAY_BUFFER,
                4L * mesh.indices().length,
                IntBuffer.wrap(mesh.indices()),
                GL.GL_DYNAMIC_DRAW);
        gl.glBindVertexArray(0);
        gl.glBindBuffer(GL.GL_ARRAY_BUFFER, 0);
    }

    private void attribute(GL3 gl, int location, Buffer values, int components, int type) {
        if (!values.hasRemaining()) {
            gl.glDisableVertexAttribArray(location);
            return;
        }
        gl.glBindBuffer(GL.GL_ARRAY_BUFFER, attributes[location]);
        gl.glBufferData(GL.GL_ARRAY_BUFFER, 4L * values.remaining(), values, GL.GL_DYNAMIC_DRAW);
        gl.glEnableVertexAttribArray(location);
        gl.glVertexAttribPointer(location, components, type, type != GL.GL_FLOAT, 0, 0L);
    }

    void bind(GL3 gl) {
        gl.glBindVertexArray(vertexArray[0]);
        // Values for missing arrays: white, no tangent, texture corner.
        gl.glVertexAttrib4f(COLOUR, 1, 1, 1, 1);
        gl.glVertexAttrib4f(TANGENT, 0, 0, 0, 0);
        for (int i = 0; i < RenderMesh.SETS; i++) gl.glVertexAttrib2f(SET_0 + i, 0, 0);
    }

    /** Gives faces another order. The vertex array must be bound. */
    void reorder(GL3 gl, int firstIndex, int[] indices) {
        gl.glBufferSubData(GL.GL_ELEMENT_ARRAY_BUFFER, 4L * firstIndex, 4L * indices.length, IntBuffer.wrap(indices));
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
