package org.jsmesh.desktop.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;

/** A buffer of the graphics card with four bytes per element, which grows. Used on the thread with the context. */
public final class GpuBuffer {
    /** A target that no vertex array remembers. */
    private static final int TARGET = GL3.GL_COPY_WRITE_BUFFER;

    private final int[] name = new int[1];
    private int room;
    private int used;

    /** Makes a buffer without room. */
    public GpuBuffer(GL3 gl) {
        gl.glGenBuffers(1, name, 0);
    }

    /** {@return the name that OpenGL knows it by; another one after it has grown} */
    public int name() {
        return name[0];
    }

    /** {@return whether there is no room yet} */
    public boolean isEmpty() {
        return room == 0;
    }

    /** {@return elements that there is room for} */
    public int room() {
        return room;
    }

    /** Makes room for so many elements. What is there stays, under another {@link #name} when there was too little. */
    public void reserve(GL3 gl, int elements) {
        if (elements <= room) return;
        int[] before = name.clone();
        if (used > 0) gl.glGenBuffers(1, name, 0);
        gl.glBindBuffer(TARGET, name[0]);
        gl.glBufferData(TARGET, 4L * elements, null, GL.GL_DYNAMIC_DRAW);
        room = elements;
        if (used == 0) return;
        gl.glBindBuffer(GL3.GL_COPY_READ_BUFFER, before[0]);
        gl.glCopyBufferSubData(GL3.GL_COPY_READ_BUFFER, TARGET, 0, 0, 4L * used);
        gl.glBindBuffer(GL3.GL_COPY_READ_BUFFER, 0);
        gl.glDeleteBuffers(1, before, 0);
    }

    /**
     * Writes elements, for which there must be room. Those that were never used are mapped, as no picture under way can
     * need them: nobody waits, and nothing is copied twice. Others go through the driver, which knows what is drawn.
     *
     * @param first element of the buffer that is written
     * @param at element of the data that is read first
     * @param count elements
     */
    public void write(GL3 gl, int first, int[] data, int at, int count) {
        if (count == 0) return;
        gl.glBindBuffer(TARGET, name[0]);
        ByteBuffer mapped = first < used
                ? null
                : gl.glMapBufferRange(
                        TARGET,
                        4L * first,
                        4L * count,
                        GL.GL_MAP_WRITE_BIT | GL.GL_MAP_INVALIDATE_RANGE_BIT | GL.GL_MAP_UNSYNCHRONIZED_BIT);
        boolean isKept = false;
        if (mapped != null) {
            mapped.order(ByteOrder.nativeOrder()).asIntBuffer().put(data, at, count);
            isKept = gl.glUnmapBuffer(TARGET);
        }
        if (!isKept) gl.glBufferSubData(TARGET, 4L * first, 4L * count, IntBuffer.wrap(data, at, count));
        used = Math.max(used, first + count);
    }

    /** Gives it back to the card. */
    public void dispose(GL3 gl) {
        gl.glDeleteBuffers(1, name, 0);
    }
}
