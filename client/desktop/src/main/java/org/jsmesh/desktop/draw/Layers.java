package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL2ES3;
import com.jogamp.opengl.GL3;
import org.jsmesh.desktop.gpu.LayerBuffers;
import org.jsmesh.desktop.gpu.ShaderProgram;

/**
 * Blends translucent surfaces pixel by pixel in their true order, whatever the order of their faces: layer after layer
 * from the front, each behind the one before (Everitt, Interactive Order-Independent Transparency, 2001). Faces that
 * are sorted by their middles come in the wrong order where they are large, or close behind each other, or go through
 * one another, and make stripes there. Used on the thread that holds the context.
 */
final class Layers {
    /** Of more, the nearest ones are seen. */
    private static final int MOST = 12;

    private static final int OPAQUE_UNIT = SurfacePass.FREE_UNIT;
    private static final int BEFORE_UNIT = SurfacePass.FREE_UNIT + 1;
    private static final int OPAQUE = 2;

    private final ShaderProgram peel;
    private final ShaderProgram layers;
    private final int[] noAttributes = new int[1];
    private final int[] query = new int[1];
    private LayerBuffers buffers;

    Layers(GL3 gl) {
        peel = new ShaderProgram(gl, "mesh", "peel");
        layers = new ShaderProgram(gl, "background", "layers");
        gl.glGenVertexArrays(1, noAttributes, 0);
        gl.glGenQueries(1, query, 0);
    }

    /** Whether the graphics card can look at single samples. */
    static boolean areOffered(GL3 gl) {
        return gl.isExtensionAvailable("GL_ARB_sample_shading");
    }

    /** What is to be drawn. The vertex array is bound. */
    interface Faces {
        /** Opaque ones, of which only the depth counts. */
        void drawOpaque();

        /** Translucent ones with the program in use. */
        void drawPlain();

        /** Translucent ones with their colours. */
        void drawColoured();
    }

    /** Draws into the framebuffer that is bound, which has the opaque surfaces already. */
    void draw(GL3 gl, int[] viewport, SurfacePass.Eye eye, int step, Faces faces) {
        int target = gl.getBoundFramebuffer(GL.GL_FRAMEBUFFER);
        prepare(gl, viewport[2], viewport[3]);
        gl.glViewport(0, 0, buffers.width, buffers.height);
        gl.glDepthMask(true);
        buffers.bind(gl, OPAQUE);
        gl.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT);
        gl.glColorMask(false, false, false, false);
        faces.drawOpaque();
        gl.glColorMask(true, true, true, true);
        buffers.bind(gl, 0);
        gl.glClear(GL.GL_COLOR_BUFFER_BIT);
        for (int layer = 0; layer < MOST && find(gl, layer, eye, step, faces); layer++) {
            gl.glDepthMask(false);
            gl.glDepthFunc(GL.GL_EQUAL);
            gl.glEnable(GL.GL_BLEND);
            gl.glBlendFunc(GL.GL_ONE_MINUS_DST_ALPHA, GL.GL_ONE);
            faces.drawColoured();
            gl.glDisable(GL.GL_BLEND);
            gl.glDepthFunc(GL.GL_LEQUAL);
            gl.glDepthMask(true);
        }
        buffers.resolve(gl);
        gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, target);
        gl.glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
        compose(gl);
    }

    private void prepare(GL3 gl, int width, int height) {
        if (buffers != null && buffers.width == width && buffers.height == height) return;
        if (buffers != null) buffers.dispose(gl);
        buffers = new LayerBuffers(gl, width, height);
    }

    /** Fills the depths with those of the next layer. False when there is none. */
    private boolean find(GL3 gl, int layer, SurfacePass.Eye eye, int step, Faces faces) {
        buffers.bind(gl, layer % 2);
        gl.glClear(GL.GL_DEPTH_BUFFER_BIT);
        peel.use(gl);
        peel.set(gl, "view", eye.view());
        peel.set(gl, "projection", eye.projection());
        peel.set(gl, "step", (float) step);
        peel.set(gl, "isFirst", layer == 0);
        peel.set(gl, "opaque", OPAQUE_UNIT);
        peel.set(gl, "before", BEFORE_UNIT);
        buffers.bindDepths(gl, OPAQUE, OPAQUE_UNIT);
        buffers.bindDepths(gl, (layer + 1) % 2, BEFORE_UNIT);
        gl.glColorMask(false, false, false, false);
        gl.glBeginQuery(GL2ES3.GL_ANY_SAMPLES_PASSED, query[0]);
        faces.drawPlain();
        gl.glEndQuery(GL2ES3.GL_ANY_SAMPLES_PASSED);
        gl.glColorMask(true, true, true, true);
        LayerBuffers.unbindDepths(gl, OPAQUE_UNIT);
        LayerBuffers.unbindDepths(gl, BEFORE_UNIT);
        int[] any = new int[1];
        gl.glGetQueryObjectuiv(query[0], GL2ES2.GL_QUERY_RESULT, any, 0);
        return any[0] != 0;
    }

    private void compose(GL3 gl) {
        gl.glDisable(GL.GL_DEPTH_TEST);
        gl.glDisable(GL.GL_CULL_FACE);
        gl.glEnable(GL.GL_BLEND);
        gl.glBlendFunc(GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA);
        layers.use(gl);
        layers.set(gl, "layers", 0);
        gl.glBindVertexArray(noAttributes[0]);
        gl.glDrawArrays(GL.GL_TRIANGLES, 0, 3);
        gl.glBindTexture(GL.GL_TEXTURE_2D, 0);
        gl.glDisable(GL.GL_BLEND);
        gl.glEnable(GL.GL_DEPTH_TEST);
    }

    void dispose(GL3 gl) {
        peel.dispose(gl);
        layers.dispose(gl);
        gl.glDeleteVertexArrays(1, noAttributes, 0);
        gl.glDeleteQueries(1, query, 0);
        if (buffers != null) buffers.dispose(gl);
    }
}
