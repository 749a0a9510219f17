package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2GL3;
import com.jogamp.opengl.GL3;
import java.nio.IntBuffer;
import java.util.HashMap;
import java.util.Map;
import org.jsmesh.studio.Opacity;

/** Textures of the graphics card by their path, with mip maps. Used on the thread that holds the context. */
final class GpuTextures {
    private final int format;
    private final Map<String, Integer> names = new HashMap<>();
    private final Map<String, TextureImage> uploaded = new HashMap<>();

    private GpuTextures(int format) {
        this.format = format;
    }

    /** The card must know that these are sRGB, so that filtering and mip maps work on linear light. */
    static GpuTextures ofColours() {
        return new GpuTextures(GL.GL_SRGB8_ALPHA8);
    }

    /** Of numbers: normals, roughness, opacity. */
    static GpuTextures ofNumbers() {
        return new GpuTextures(GL.GL_RGBA8);
    }

    /** Uploads the images that are not there yet. An image replaces its preview. */
    void upload(GL3 gl, Map<String, TextureImage> images) {
        images.forEach((path, image) -> {
            if (uploaded.put(path, image) == image) return;
            Integer before = names.put(path, create(gl, image));
            if (before != null) gl.glDeleteTextures(1, new int[] {before}, 0);
        });
    }

    /** What the opacity of a texture means; opaque until it has arrived. */
    Opacity opacity(String path) {
        TextureImage image = path == null ? null : uploaded.get(path);
        return image == null ? Opacity.OPAQUE : image.opacity();
    }

    /** Binds the texture to the active unit, if it has arrived. */
    boolean bind(GL3 gl, String path) {
        Integer name = path == null ? null : names.get(path);
        gl.glBindTexture(GL.GL_TEXTURE_2D, name == null ? 0 : name);
        return name != null;
    }

    void dispose(GL3 gl) {
        for (int name : names.values()) gl.glDeleteTextures(1, new int[] {name}, 0);
        names.clear();
        uploaded.clear();
    }

    private int create(GL3 gl, TextureImage original) {
        TextureImage image = fit(gl, original);
        int[] name = new int[1];
        gl.glGenTextures(1, name, 0);
        gl.glBindTexture(GL.GL_TEXTURE_2D, name[0]);
        gl.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 4);
        gl.glTexImage2D(
                GL.GL_TEXTURE_2D,
                0,
                format,
                image.width(),
                image.height(),
                0,
                GL.GL_BGRA,
                GL2GL3.GL_UNSIGNED_INT_8_8_8_8_REV,
                IntBuffer.wrap(image.argb()));
        gl.glGenerateMipmap(GL.GL_TEXTURE_2D);
        return name[0];
    }

    /** Halves an image until the card takes it. */
    private static TextureImage fit(GL3 gl, TextureImage original) {
        int[] most = new int[1];
        gl.glGetIntegerv(GL.GL_MAX_TEXTURE_SIZE, most, 0);
        int step = 1;
        while (Math.max(original.width(), original.height()) / step > most[0]) step *= 2;
        if (step == 1) return original;
        int width = Math.max(1, original.width() / step);
        int height = Math.max(1, original.height() / step);
        int[] argb = new int[width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++)
                argb[y * width + x] = original.argb()[y * step * original.width() + x * step];
        }
        return new TextureImage(width, height, argb, original.opacity());
    }
}
