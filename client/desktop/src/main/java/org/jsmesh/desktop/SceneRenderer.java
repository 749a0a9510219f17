package org.jsmesh.desktop;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2GL3;
import com.jogamp.opengl.GL3;
import org.jsmesh.display.DisplayMaterial;

/**
 * Draws scenes with OpenGL 3.3 core into whatever framebuffer is bound. All methods are called on the thread that holds
 * the context. Every binding is undone, because Swing's own OpenGL needs that.
 */
final class SceneRenderer {
    private final ShaderProgram surfaces;
    private final ShaderProgram backdrop;
    private final int[] noAttributes = new int[1];
    private final GpuMesh mesh;
    private final GpuTextures textures = new GpuTextures();
    private Scene scene;

    SceneRenderer(GL3 gl) {
        surfaces = new ShaderProgram(gl, "mesh");
        backdrop = new ShaderProgram(gl, "background");
        gl.glGenVertexArrays(1, noAttributes, 0);
        mesh = new GpuMesh(gl);
    }

    /** Sets the scene to draw. */
    void upload(GL3 gl, Scene next) {
        mesh.upload(gl, next.mesh());
        textures.upload(gl, next.images());
        scene = next;
    }

    /**
     * @param camera may be null before the first upload
     * @param background false leaves pixels without surface transparent; colours are premultiplied with opacity
     * @param wireframe draws the edges of the triangles only
     */
    void draw(GL3 gl, Camera camera, int width, int height, boolean background, boolean wireframe) {
        gl.glViewport(0, 0, width, height);
        gl.glClearColor(0, 0, 0, 0);
        gl.glDepthMask(true);
        gl.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT);
        if (background) drawBackground(gl);
        gl.glPolygonMode(GL.GL_FRONT_AND_BACK, wireframe ? GL2GL3.GL_LINE : GL2GL3.GL_FILL);
        if (scene != null && camera != null) drawScene(gl, camera, width, height);
        gl.glPolygonMode(GL.GL_FRONT_AND_BACK, GL2GL3.GL_FILL);
        gl.glUseProgram(0);
        gl.glBindVertexArray(0);
        gl.glBindTexture(GL.GL_TEXTURE_2D, 0);
    }

    private void drawBackground(GL3 gl) {
        gl.glDisable(GL.GL_DEPTH_TEST);
        backdrop.use(gl);
        backdrop.set(gl, "bottom", Lighting.BACKGROUND_BOTTOM);
        backdrop.set(gl, "top", Lighting.BACKGROUND_TOP);
        gl.glBindVertexArray(noAttributes[0]);
        gl.glDrawArrays(GL.GL_TRIANGLES, 0, 3);
    }

    private void drawScene(GL3 gl, Camera camera, int width, int height) {
        gl.glEnable(GL.GL_DEPTH_TEST);
        gl.glDepthFunc(GL.GL_LEQUAL);
        gl.glDisable(GL.GL_CULL_FACE);
        gl.glBlendFunc(GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA);
        surfaces.use(gl);
        surfaces.set(gl, "view", camera.view());
        surfaces.set(gl, "projection", camera.projection(width, height));
        light(gl);
        mesh.bind(gl);
        int[] groups = scene.mesh().groups();
        for (int g = 0; g < groups.length; g += 3) {
            if (groups[g + 2] == 0) continue;
            set(gl, scene.mesh().slots().materials().get(groups[g]));
            mesh.draw(gl, groups[g + 1], groups[g + 2]);
        }
        gl.glDepthMask(true);
        gl.glDisable(GL.GL_BLEND);
        gl.glDisable(GL.GL_DEPTH_TEST);
    }

    private void set(GL3 gl, DisplayMaterial material) {
        boolean textured = textures.bind(gl, material.texture()) && scene.mesh().textureCoordinates().length > 0;
        surfaces.set(gl, "surface", LinearColour.of(material, textured));
        surfaces.set(gl, "textured", textured);
        surfaces.set(gl, "imageFromTop", material.gltf());
        // Translucent slots come last; without depth of their own they show each other in any order.
        if (material.isOpaque()) gl.glDisable(GL.GL_BLEND);
        else gl.glEnable(GL.GL_BLEND);
        gl.glDepthMask(material.isOpaque());
    }

    private void light(GL3 gl) {
        surfaces.set(gl, "sky", Lighting.SKY);
        surfaces.set(gl, "ground", Lighting.GROUND);
        surfaces.set(gl, "keyDirection", Lighting.KEY_DIRECTION);
        surfaces.set(gl, "keyLight", Lighting.KEY);
        surfaces.set(gl, "fillDirection", Lighting.FILL_DIRECTION);
        surfaces.set(gl, "fillLight", Lighting.FILL);
        surfaces.set(gl, "highlight", Lighting.HIGHLIGHT);
        surfaces.set(gl, "shininess", Lighting.SHININESS);
    }

    void dispose(GL3 gl) {
        surfaces.dispose(gl);
        backdrop.dispose(gl);
        gl.glDeleteVertexArrays(1, noAttributes, 0);
        mesh.dispose(gl);
        textures.dispose(gl);
    }
}
