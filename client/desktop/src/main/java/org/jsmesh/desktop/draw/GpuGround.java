package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import org.jsmesh.desktop.gpu.ShaderProgram;
import org.jsmesh.studio.ContactShadow;
import org.jsmesh.studio.Ground;

/** What is seen behind a model, and beneath it. Used on the thread that holds the context. */
final class GpuGround {
    private final ShaderProgram backdrop;
    private final ShaderProgram ground;
    private final int[] noAttributes = new int[1];
    private final int[] cells = new int[1];
    private ContactShadow shadow;

    GpuGround(GL3 gl) {
        backdrop = new ShaderProgram(gl, "background");
        ground = new ShaderProgram(gl, "ground");
        gl.glGenVertexArrays(1, noAttributes, 0);
        gl.glGenTextures(1, cells, 0);
    }

    private void upload(GL3 gl, ContactShadow next) {
        if (next == shadow) return;
        shadow = next;
        gl.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 4);
        gl.glBindTexture(GL.GL_TEXTURE_2D, cells[0]);
        gl.glTexImage2D(
                GL.GL_TEXTURE_2D,
                0,
                GL.GL_R8,
                ContactShadow.SIDE,
                ContactShadow.SIDE,
                0,
                GL2ES2.GL_RED,
                GL.GL_UNSIGNED_BYTE,
                ByteBuffer.wrap(shadow.cells()));
        for (int filter : new int[] {GL.GL_TEXTURE_MIN_FILTER, GL.GL_TEXTURE_MAG_FILTER})
            gl.glTexParameteri(GL.GL_TEXTURE_2D, filter, GL.GL_LINEAR);
        for (int wrap : new int[] {GL.GL_TEXTURE_WRAP_S, GL.GL_TEXTURE_WRAP_T})
            gl.glTexParameteri(GL.GL_TEXTURE_2D, wrap, GL.GL_CLAMP_TO_EDGE);
        gl.glBindTexture(GL.GL_TEXTURE_2D, 0);
    }

    void drawBackdrop(GL3 gl) {
        gl.glDisable(GL.GL_DEPTH_TEST);
        backdrop.use(gl);
        backdrop.set(gl, "middle", Ground.middle());
        backdrop.set(gl, "corner", Ground.corner());
        backdrop.set(gl, "spot", Ground.spot());
        gl.glBindVertexArray(noAttributes[0]);
        gl.glDrawArrays(GL.GL_TRIANGLES, 0, 3);
    }

    /** Darkens the ground where it is seen from above, before the model is drawn. No shadow is null. */
    void drawShadow(GL3 gl, ContactShadow cast, Camera camera, int width, int height) {
        if (cast == null) return;
        upload(gl, cast);
        if (camera.eye()[1] <= shadow.height()) return;
        ground.use(gl);
        ground.set(gl, "view", camera.view());
        ground.set(gl, "projection", camera.projection(width, height));
        ground.set(gl, "extent", (float) shadow.half());
        ground.set(gl, "height", (float) shadow.height());
        ground.set(gl, "darkest", ContactShadow.DARKEST);
        ground.set(gl, "shadow", 0);
        gl.glActiveTexture(GL.GL_TEXTURE0);
        gl.glBindTexture(GL.GL_TEXTURE_2D, cells[0]);
        gl.glBindSampler(0, 0);
        gl.glBindVertexArray(noAttributes[0]);
        gl.glDisable(GL.GL_DEPTH_TEST);
        gl.glEnable(GL.GL_BLEND);
        gl.glBlendFunc(GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA);
        gl.glDrawArrays(GL.GL_TRIANGLE_STRIP, 0, 4);
        gl.glDisable(GL.GL_BLEND);
    }

    void dispose(GL3 gl) {
        backdrop.dispose(gl);
        ground.dispose(gl);
        gl.glDeleteVertexArrays(1, noAttributes, 0);
        gl.glDeleteTextures(1, cells, 0);
    }
}
