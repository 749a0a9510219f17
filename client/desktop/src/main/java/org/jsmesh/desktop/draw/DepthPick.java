package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.util.function.Consumer;

/**
 * Finds what lies beneath a place of the picture: draws one pixel of it. The depth of the picture itself cannot be read
 * where it has several samples per pixel. Used on the thread that holds the context.
 */
final class DepthPick {
    private DepthPick() {}

    /**
     * @param across from −1 at the left edge to 1 at the right one
     * @param along from −1 at the lower edge to 1 at the upper one
     * @param draw fills the depth of a picture of one pixel with the projection that it is given
     * @return the point of the model, or null where there is none
     */
    static double[] at(
            GL3 gl, Camera camera, int width, int height, double across, double along, Consumer<double[]> draw) {
        double[] projection = camera.projection(width, height);
        double depth = depth(gl, () -> draw.accept(pixel(projection, width, height, across, along)));
        if (depth >= 1) return null;
        double before = projection[14] / (2 * depth - 1 + projection[10]);
        return camera.point(across, along, (double) width / height, before);
    }

    /** A projection to the one pixel at a place. */
    private static double[] pixel(double[] projection, int width, int height, double across, double along) {
        double[] p = projection.clone();
        for (int column = 0; column < 4; column++) {
            p[4 * column] = width * (p[4 * column] - across * p[4 * column + 3]);
            p[4 * column + 1] = height * (p[4 * column + 1] - along * p[4 * column + 3]);
        }
        return p;
    }

    private static double depth(GL3 gl, Runnable draw) {
        int before = gl.getBoundFramebuffer(GL.GL_FRAMEBUFFER);
        int[] names = new int[2];
        gl.glGenFramebuffers(1, names, 0);
        gl.glGenRenderbuffers(1, names, 1);
        gl.glBindRenderbuffer(GL.GL_RENDERBUFFER, names[1]);
        gl.glRenderbufferStorage(GL.GL_RENDERBUFFER, GL.GL_DEPTH_COMPONENT32, 1, 1);
        gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, names[0]);
        gl.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, GL.GL_DEPTH_ATTACHMENT, GL.GL_RENDERBUFFER, names[1]);
        gl.glDrawBuffer(GL.GL_NONE);
        gl.glReadBuffer(GL.GL_NONE);
        gl.glViewport(0, 0, 1, 1);
        gl.glDepthMask(true);
        gl.glClear(GL.GL_DEPTH_BUFFER_BIT);
        draw.run();
        float[] depth = new float[1];
        gl.glReadPixels(0, 0, 1, 1, GL2ES2.GL_DEPTH_COMPONENT, GL.GL_FLOAT, FloatBuffer.wrap(depth));
        gl.glBindFramebuffer(GL.GL_FRAMEBUFFER, before);
        gl.glDeleteFramebuffers(1, names, 0);
        gl.glDeleteRenderbuffers(1, names, 1);
        return depth[0];
    }
}
