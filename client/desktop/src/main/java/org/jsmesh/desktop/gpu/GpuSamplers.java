package org.jsmesh.desktop.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.jsmesh.display.TextureUse;

/** Filters and wrapping of textures on the graphics card. Used on the thread that holds the context. */
public final class GpuSamplers {
    private static final Set<Integer> BETWEEN_PIXELS = Set.of(GL.GL_NEAREST, GL.GL_LINEAR);
    private static final Set<Integer> SMALLER = Set.of(
            GL.GL_NEAREST,
            GL.GL_LINEAR,
            GL.GL_NEAREST_MIPMAP_NEAREST,
            GL.GL_LINEAR_MIPMAP_NEAREST,
            GL.GL_NEAREST_MIPMAP_LINEAR,
            GL.GL_LINEAR_MIPMAP_LINEAR);
    private static final Set<Integer> OUTSIDE = Set.of(GL.GL_REPEAT, GL.GL_CLAMP_TO_EDGE, GL.GL_MIRRORED_REPEAT);

    private final Map<TextureUse.Sampler, Integer> names = new HashMap<>();

    /** Binds a sampler to a texture unit; it is made when it is used for the first time. */
    public void bind(GL3 gl, int unit, TextureUse.Sampler sampler) {
        gl.glBindSampler(unit, names.computeIfAbsent(sampler, s -> create(gl, s)));
    }

    private static int create(GL3 gl, TextureUse.Sampler s) {
        int[] name = new int[1];
        gl.glGenSamplers(1, name, 0);
        set(gl, name[0], GL.GL_TEXTURE_MAG_FILTER, s.magFilter(), BETWEEN_PIXELS, GL.GL_LINEAR);
        set(gl, name[0], GL.GL_TEXTURE_MIN_FILTER, s.minFilter(), SMALLER, GL.GL_LINEAR_MIPMAP_LINEAR);
        set(gl, name[0], GL.GL_TEXTURE_WRAP_S, s.wrapU(), OUTSIDE, GL.GL_REPEAT);
        set(gl, name[0], GL.GL_TEXTURE_WRAP_T, s.wrapV(), OUTSIDE, GL.GL_REPEAT);
        return name[0];
    }

    /** A file may say any number. */
    private static void set(GL3 gl, int name, int parameter, int value, Set<Integer> known, int usual) {
        gl.glSamplerParameteri(name, parameter, known.contains(value) ? value : usual);
    }

    /** Gives all of them back to the card. */
    public void dispose(GL3 gl) {
        for (int name : names.values()) gl.glDeleteSamplers(1, new int[] {name}, 0);
        names.clear();
    }
}
