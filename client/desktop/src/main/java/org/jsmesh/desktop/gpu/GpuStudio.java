package org.jsmesh.desktop.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import org.jsmesh.studio.Lighting;
import org.jsmesh.studio.Reflectance;
import org.jsmesh.studio.Studio;

/** The {@link Studio} and the table of reflectances on the graphics card. Used on the thread that holds the context. */
public final class GpuStudio {
    private final int[] names = new int[2];

    /** Brings both to the card. */
    public GpuStudio(GL3 gl) {
        gl.glGenTextures(2, names, 0);
        gl.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 4);
        gl.glBindTexture(GL2ES2.GL_TEXTURE_3D, names[0]);
        gl.glTexImage3D(
                GL2ES2.GL_TEXTURE_3D,
                0,
                GL.GL_R16F,
                Studio.SIDE,
                Studio.SIDE,
                Studio.LEVELS,
                0,
                GL2ES2.GL_RED,
                GL.GL_FLOAT,
                FloatBuffer.wrap(Tables.LIGHT));
        filter(gl, GL2ES2.GL_TEXTURE_3D);
        gl.glBindTexture(GL.GL_TEXTURE_2D, names[1]);
        gl.glTexImage2D(
                GL.GL_TEXTURE_2D,
                0,
                GL.GL_RG16F,
                Reflectance.SIDE,
                Reflectance.SIDE,
                0,
                GL2ES2.GL_RG,
                GL.GL_FLOAT,
                FloatBuffer.wrap(Tables.REFLECTANCES));
        filter(gl, GL.GL_TEXTURE_2D);
        unbind(gl);
    }

    private static void filter(GL3 gl, int target) {
        gl.glTexParameteri(target, GL.GL_TEXTURE_MIN_FILTER, GL.GL_LINEAR);
        gl.glTexParameteri(target, GL.GL_TEXTURE_MAG_FILTER, GL.GL_LINEAR);
        for (int wrap : new int[] {GL.GL_TEXTURE_WRAP_S, GL.GL_TEXTURE_WRAP_T, GL2ES2.GL_TEXTURE_WRAP_R})
            gl.glTexParameteri(target, wrap, GL.GL_CLAMP_TO_EDGE);
    }

    /** Binds both to texture units, and tells a program of them. */
    public void bind(GL3 gl, ShaderProgram program, int lightUnit, int reflectancesUnit) {
        gl.glActiveTexture(GL.GL_TEXTURE0 + lightUnit);
        gl.glBindTexture(GL2ES2.GL_TEXTURE_3D, names[0]);
        gl.glActiveTexture(GL.GL_TEXTURE0 + reflectancesUnit);
        gl.glBindTexture(GL.GL_TEXTURE_2D, names[1]);
        gl.glActiveTexture(GL.GL_TEXTURE0);
        program.set(gl, "studio", lightUnit);
        program.set(gl, "reflectances", reflectancesUnit);
        program.set(gl, "studioLight", Lighting.STUDIO);
        program.set(gl, "studioLevels", (float) Studio.LEVELS);
        program.set(gl, "studioSide", (float) Studio.SIDE);
    }

    private static void unbind(GL3 gl) {
        gl.glBindTexture(GL2ES2.GL_TEXTURE_3D, 0);
        gl.glBindTexture(GL.GL_TEXTURE_2D, 0);
    }

    /** Leaves nothing bound to both units. */
    public static void unbind(GL3 gl, int lightUnit, int reflectancesUnit) {
        for (int unit : new int[] {lightUnit, reflectancesUnit}) {
            gl.glActiveTexture(GL.GL_TEXTURE0 + unit);
            unbind(gl);
        }
    }

    /** Gives both back to the card. */
    public void dispose(GL3 gl) {
        gl.glDeleteTextures(2, names, 0);
    }

    /** Computed once for all windows, when the first one opens. */
    private static final class Tables {
        static final float[] LIGHT = Studio.light();
        static final float[] REFLECTANCES = Reflectance.table();
    }
}
