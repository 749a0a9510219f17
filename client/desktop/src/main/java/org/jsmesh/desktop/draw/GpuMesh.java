package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import org.jsmesh.desktop.gpu.GpuBuffer;
import org.jsmesh.display.LiveStep;
import org.jsmesh.display.RenderMesh;

/** {@link MeshArrays} in buffers of the graphics card. Used on the thread that holds the context. */
final class GpuMesh {
    private static final int NONE = -1;
    private static final int COLOUR = 2;
    private static final int TANGENT = 3;
    private static final int SET_0 = 4;
    private static final int START = 8;
    private static final int DISTANCE = 9;

    /** Places in the shader of the arrays of {@link MeshArrays}. */
    private static final int[] LOCATIONS = {
        0, 1, COLOUR, NONE, NONE, TANGENT, SET_0, SET_0 + 1, SET_0 + 2, SET_0 + 3, START, DISTANCE
    };

    private final int[] vertexArray = new int[1];
    private final GpuBuffer[] buffers = new GpuBuffer[MeshArrays.COUNT];
    private final GpuBuffer sorted;

    GpuMesh(GL3 gl) {
        gl.glGenVertexArrays(1, vertexArray, 0);
        sorted = new GpuBuffer(gl);
    }

    /** Makes room for so many elements of an array. Says whether there was less. */
    boolean reserve(GL3 gl, int array, int elements) {
        if (buffers[array] == null) buffers[array] = new GpuBuffer(gl);
        int before = buffers[array].name();
        boolean isNew = buffers[array].isEmpty();
        boolean isMore = buffers[array].room() < elements;
        buffers[array].reserve(gl, elements);
        if (LOCATIONS[array] != NONE && (isNew || buffers[array].name() != before)) connect(gl, array);
        return isMore;
    }

    private void connect(GL3 gl, int array) {
        int location = LOCATIONS[array];
        boolean isColour = array == LiveStep.COLOURS;
        gl.glBindVertexArray(vertexArray[0]);
        gl.glBindBuffer(GL.GL_ARRAY_BUFFER, buffers[array].name());
        gl.glEnableVertexAttribArray(location);
        // Red is the lowest byte, and so the first one: every machine that JOGL has natives for is little-endian.
        if (isColour) gl.glVertexAttribPointer(location, 4, GL.GL_UNSIGNED_BYTE, true, 0, 0L);
        else gl.glVertexAttribPointer(location, MeshArrays.width(array), GL.GL_FLOAT, false, 0, 0L);
        gl.glBindBuffer(GL.GL_ARRAY_BUFFER, 0);
        gl.glBindVertexArray(0);
    }

    /** Writes elements of an array, for which there must be room. */
    void write(GL3 gl, int array, int first, int[] data, int at, int count) {
        buffers[array].write(gl, first, data, at, count);
    }

    /** Takes over all that is used. */
    void write(GL3 gl, MeshArrays arrays) {
        for (int a = 0; a < MeshArrays.COUNT; a++) {
            if (!arrays.has(a)) continue;
            reserve(gl, a, arrays.used(a));
            write(gl, a, 0, arrays.bits(a), 0, arrays.used(a));
        }
    }

    void bind(GL3 gl) {
        gl.glBindVertexArray(vertexArray[0]);
        // Values for missing arrays: white, no tangent, texture corner, a start that no step has.
        gl.glVertexAttrib4f(COLOUR, 1, 1, 1, 1);
        gl.glVertexAttrib4f(TANGENT, 0, 0, 0, 0);
        gl.glVertexAttrib4f(START, 0, 0, 0, 0);
        gl.glVertexAttrib1f(DISTANCE, 0);
        for (int i = 0; i < RenderMesh.SETS; i++) gl.glVertexAttrib2f(SET_0 + i, 0, 0);
    }

    /** The vertex array must be bound. Triangles are drawn in the order of their places from now on. */
    void usePlaces(GL3 gl) {
        gl.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, buffers[LiveStep.INDICES].name());
    }

    /** The vertex array must be bound. Other triangles are drawn from now on. */
    void useSorted(GL3 gl) {
        gl.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, sorted.name());
    }

    /** Replaces those other triangles. */
    void sort(GL3 gl, int[] indices) {
        sorted.reserve(gl, indices.length);
        sorted.write(gl, 0, indices, 0, indices.length);
    }

    /** Draws triangles. */
    void draw(GL3 gl, int firstIndex, int indices) {
        gl.glDrawElements(GL.GL_TRIANGLES, indices, GL.GL_UNSIGNED_INT, 4L * firstIndex);
    }

    void dispose(GL3 gl) {
        gl.glDeleteVertexArrays(1, vertexArray, 0);
        for (GpuBuffer buffer : buffers) if (buffer != null) buffer.dispose(gl);
        sorted.dispose(gl);
    }
}
