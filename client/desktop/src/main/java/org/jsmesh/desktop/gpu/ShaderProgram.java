package org.jsmesh.desktop.gpu;

import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;

/** A linked pair of shaders from the resources of this package. Used on the thread that holds the context. */
public final class ShaderProgram {
    private final int id;
    private final Map<String, Integer> locations = new HashMap<>();

    /**
     * @param name of the two resources, without {@code .vert} and {@code .frag}
     * @throws IllegalStateException with the driver's words when it refuses them
     */
    public ShaderProgram(GL3 gl, String name) {
        this(gl, name, name);
    }

    /**
     * Of shaders with different names.
     *
     * @param vertexName of the resource, without {@code .vert}
     * @param name of the other one, without {@code .frag}
     * @throws IllegalStateException with the driver's words when it refuses them
     */
    public ShaderProgram(GL3 gl, String vertexName, String name) {
        int vertex = compile(gl, GL2ES2.GL_VERTEX_SHADER, vertexName + ".vert");
        int fragment = compile(gl, GL2ES2.GL_FRAGMENT_SHADER, name + ".frag");
        id = gl.glCreateProgram();
        gl.glAttachShader(id, vertex);
        gl.glAttachShader(id, fragment);
        gl.glLinkProgram(id);
        int[] status = new int[1];
        gl.glGetProgramiv(id, GL2ES2.GL_LINK_STATUS, status, 0);
        if (status[0] == 0) throw refused(gl, name, programLog(gl));
        gl.glDeleteShader(vertex);
        gl.glDeleteShader(fragment);
    }

    /** Draws with it from now on. */
    public void use(GL3 gl) {
        gl.glUseProgram(id);
    }

    /** Sets a matrix of four by four, column by column. The program is in use, as for the others. */
    public void set(GL3 gl, String uniform, double[] matrix) {
        float[] m = new float[16];
        for (int i = 0; i < 16; i++) m[i] = (float) matrix[i];
        gl.glUniformMatrix4fv(location(gl, uniform), 1, false, m, 0);
    }

    /**
     * Sets a number or a vector.
     *
     * @throws IllegalArgumentException when there are not 1 to 4 values
     */
    public void set(GL3 gl, String uniform, float... values) {
        switch (values.length) {
            case 1 -> gl.glUniform1fv(location(gl, uniform), 1, values, 0);
            case 2 -> gl.glUniform2fv(location(gl, uniform), 1, values, 0);
            case 3 -> gl.glUniform3fv(location(gl, uniform), 1, values, 0);
            case 4 -> gl.glUniform4fv(location(gl, uniform), 1, values, 0);
            default -> throw new IllegalArgumentException(values.length + " values for " + uniform);
        }
    }

    /** Sets a truth value. */
    public void set(GL3 gl, String uniform, boolean value) {
        gl.glUniform1i(location(gl, uniform), value ? 1 : 0);
    }

    /** Sets an integer, or for a sampler the texture unit that it reads from. */
    public void set(GL3 gl, String uniform, int value) {
        gl.glUniform1i(location(gl, uniform), value);
    }

    /** Gives it back to the card. */
    public void dispose(GL3 gl) {
        gl.glDeleteProgram(id);
    }

    private int location(GL3 gl, String uniform) {
        return locations.computeIfAbsent(uniform, u -> gl.glGetUniformLocation(id, u));
    }

    private static int compile(GL3 gl, int type, String resource) {
        int shader = gl.glCreateShader(type);
        String source = read(resource);
        gl.glShaderSource(shader, 1, new String[] {source}, null);
        gl.glCompileShader(shader);
        int[] status = new int[1];
        gl.glGetShaderiv(shader, GL2ES2.GL_COMPILE_STATUS, status, 0);
        if (status[0] == 0) throw refused(gl, resource, shaderLog(gl, shader));
        return shader;
    }

    private static IllegalStateException refused(GL3 gl, String name, String log) {
        return new IllegalStateException(
                "The graphics driver (" + gl.glGetString(GL3.GL_VERSION) + ") refuses the shader " + name + ": "
                        + log.strip() + ". OpenGL 3.3 is needed; a newer driver may offer it.");
    }

    private String programLog(GL3 gl) {
        byte[] log = new byte[4096];
        int[] length = new int[1];
        gl.glGetProgramInfoLog(id, log.length, length, 0, log, 0);
        return new String(log, 0, length[0], StandardCharsets.UTF_8);
    }

    private static String shaderLog(GL3 gl, int shader) {
        byte[] log = new byte[4096];
        int[] length = new int[1];
        gl.glGetShaderInfoLog(shader, log.length, length, 0, log, 0);
        return new String(log, 0, length[0], StandardCharsets.UTF_8);
    }

    private static String read(String resource) {
        try (InputStream in = ShaderProgram.class.getResourceAsStream(resource)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
