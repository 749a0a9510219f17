package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2GL3;
import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.studio.Lighting;

/**
 * Draws scenes with OpenGL 3.3 core into whatever framebuffer is bound. All methods are called on the thread that holds
 * the context. Every binding is undone, because Swing's own OpenGL needs that.
 */
public final class SceneRenderer {
    private final ShaderProgram surfaces;
    private final GpuGround ground;
    private final GpuMesh mesh;
    private final GpuStudio studio;
    private final Surface surface = new Surface();
    private Scene scene;
    /** Translucent groups in their order, and the view that they were sorted for. */
    private List<Integer> sorted;
    /** Whether faces are left out that are seen from behind, whatever their material. */
    private boolean isOneSided;

    private double[] sortedFor;

    public SceneRenderer(GL3 gl) {
        surfaces = new ShaderProgram(gl, "mesh");
        ground = new GpuGround(gl);
        mesh = new GpuMesh(gl);
        studio = new GpuStudio(gl);
    }

    /** Sets the scene to draw. */
    public void upload(GL3 gl, Scene next) {
        mesh.upload(gl, next.mesh());
        surface.upload(gl, next);
        ground.upload(gl, next.shadow());
        scene = next;
        sortedFor = null;
    }

    /**
     * @param camera may be null before the first upload
     * @param background false leaves pixels without surface transparent; colours are premultiplied with opacity
     * @param wireframe draws the edges of the triangles only
     */
    public void draw(GL3 gl, Camera camera, int width, int height, boolean background, boolean wireframe) {
        gl.glViewport(0, 0, width, height);
        gl.glClearColor(0, 0, 0, 0);
        gl.glDepthMask(true);
        gl.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT);
        if (background) ground.drawBackdrop(gl);
        // No part of the model is below the ground, so it hides the shadow wherever it is.
        if (background && scene != null && camera != null) ground.drawShadow(gl, camera, width, height);
        gl.glPolygonMode(GL.GL_FRONT_AND_BACK, wireframe ? GL2GL3.GL_LINE : GL2GL3.GL_FILL);
        isOneSided = !wireframe && camera != null && isSolidSeenFrom(camera.eye());
        if (scene != null && camera != null) drawScene(gl, camera, width, height);
        gl.glPolygonMode(GL.GL_FRONT_AND_BACK, GL2GL3.GL_FILL);
        gl.glUseProgram(0);
        gl.glBindVertexArray(0);
        GpuStudio.unbind(gl, Surface.UNITS, Surface.UNITS + 1);
        Surface.unbind(gl);
    }

    /** From outside, no face of a solid is seen from behind, but where a rounding error turns it. */
    private boolean isSolidSeenFrom(double[] eye) {
        return scene != null
                && scene.isClosed()
                && eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2] > 1
                && scene.mesh().slots().materials().stream().allMatch(surface::isSolid);
    }

    private void drawScene(GL3 gl, Camera camera, int width, int height) {
        gl.glEnable(GL.GL_DEPTH_TEST);
        gl.glDepthFunc(GL.GL_LEQUAL);
        gl.glCullFace(GL.GL_BACK);
        surfaces.use(gl);
        surfaces.set(gl, "view", camera.view());
        surfaces.set(gl, "projection", camera.projection(width, height));
        light(gl);
        mesh.bind(gl);
        List<Integer> opaque = new ArrayList<>();
        List<Integer> translucent = new ArrayList<>();
        int[] groups = scene.mesh().groups();
        for (int g = 0; g < groups.length; g += 3) {
            if (groups[g + 2] > 0) (surface.isTranslucent(material(g)) ? translucent : opaque).add(g);
        }
        for (int g : opaque) drawGroup(gl, g);
        if (!translucent.isEmpty()) drawTranslucent(gl, translucent, camera.view());
        gl.glDisable(GL.GL_CULL_FACE);
        gl.glDisable(GL.GL_DEPTH_TEST);
    }

    /** What lets light through comes last; it has no depth of its own. */
    private void drawTranslucent(GL3 gl, List<Integer> translucent, double[] view) {
        if (!Arrays.equals(view, sortedFor)) {
            FarFirst order = new FarFirst(scene.mesh(), view);
            sorted = order.groups(translucent);
            for (int g : translucent) {
                int first = scene.mesh().groups()[g + 1];
                mesh.reorder(gl, first, order.faces(first, scene.mesh().groups()[g + 2]));
            }
            sortedFor = view;
        }
        gl.glEnable(GL.GL_BLEND);
        gl.glBlendFunc(GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA);
        gl.glDepthMask(false);
        for (int g : sorted) drawGroup(gl, g);
        gl.glDepthMask(true);
        gl.glDisable(GL.GL_BLEND);
    }

    private DisplayMaterial material(int group) {
        return scene.mesh().slots().materials().get(scene.mesh().groups()[group]);
    }

    private void drawGroup(GL3 gl, int group) {
        DisplayMaterial material = material(group);
        surface.set(gl, surfaces, material);
        if (material.doubleSided() && !isOneSided) gl.glDisable(GL.GL_CULL_FACE);
        else gl.glEnable(GL.GL_CULL_FACE);
        mesh.draw(gl, scene.mesh().groups()[group + 1], scene.mesh().groups()[group + 2]);
    }

    private void light(GL3 gl) {
        surfaces.set(gl, "sky", Lighting.SKY);
        surfaces.set(gl, "ground", Lighting.GROUND);
        surfaces.set(gl, "keyDirection", Lighting.KEY_DIRECTION);
        surfaces.set(gl, "keyLight", Lighting.KEY);
        surfaces.set(gl, "exposure", Lighting.EXPOSURE);
        Surface.giveUnits(gl, surfaces);
        studio.bind(gl, surfaces, Surface.UNITS, Surface.UNITS + 1);
    }

    public void dispose(GL3 gl) {
        surfaces.dispose(gl);
        ground.dispose(gl);
        mesh.dispose(gl);
        studio.dispose(gl);
        surface.dispose(gl);
    }
}
