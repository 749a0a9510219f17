package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2GL3;
import com.jogamp.opengl.GL3;
import java.util.Arrays;
import org.jsmesh.desktop.gpu.GpuLevels;
import org.jsmesh.desktop.gpu.GpuStudio;
import org.jsmesh.desktop.gpu.ShaderProgram;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.studio.Lighting;

/** Draws the surfaces of scenes. Used on the thread that holds the context. */
final class SurfacePass {
    private static final int LIGHT_UNIT = Surface.UNITS;
    private static final int REFLECTANCES_UNIT = Surface.UNITS + 1;
    private static final int LEVELS_UNIT = Surface.UNITS + 2;
    /** Texture units from here on are free. */
    static final int FREE_UNIT = Surface.UNITS + 3;

    private static final int EDGES = Shading.values().length;

    /** Of triangles, premultiplied. */
    private static final float[] EDGE_COLOUR = {0, 0, 0, .5f};

    /** No step has this number. */
    private static final float NO_STEP = -1;

    private final ShaderProgram program;
    private final GpuStudio studio;
    private final Surface surface = new Surface();
    private final Layers layers; // or null

    /** Where the eye is. */
    record Eye(double[] view, double[] projection, double[] place) {
        boolean isOutside() {
            return place[0] * place[0] + place[1] * place[1] + place[2] * place[2] > 1;
        }
    }

    /** @param layers draws what is translucent; null leaves that to sorted faces */
    SurfacePass(GL3 gl, Layers layers) {
        program = new ShaderProgram(gl, "mesh");
        studio = new GpuStudio(gl);
        this.layers = layers;
    }

    /**
     * @param step that is unfinished, or −1
     * @param most the number at the bright end of the palette
     */
    void draw(GL3 gl, GpuScene scene, int step, Eye eye, DrawStyle style, double most) {
        begin(gl, scene, step, eye);
        boolean isLit = style.shading() == Shading.MATERIALS || style.shading() == Shading.FLAT;
        boolean isOneSided = isSolidSeenFrom(eye, scene.shown());
        program.set(gl, "shading", style.shading().ordinal());
        program.set(gl, "most", (float) most);
        if (style.shading() == Shading.LEVELS) scene.bindLevels(gl, LEVELS_UNIT);
        if (style.wireframe()) gl.glEnable(GL.GL_POLYGON_OFFSET_FILL);
        gl.glPolygonOffset(1, 1);
        int[] groups = scene.shown().groups;
        int[] blended = isLit ? blended(scene.shown()) : new int[0];
        scene.mesh.usePlaces(gl);
        for (int g = 0; g < groups.length; g += 3)
            if (!isLit || !isBlended(scene.shown(), groups[g])) drawRun(gl, scene, groups, g, isLit, isOneSided);
        gl.glDisable(GL.GL_POLYGON_OFFSET_FILL);
        if (blended.length > 0 && layers == null) drawSorted(gl, scene, blended, eye.view(), isOneSided);
        if (blended.length > 0 && layers != null) {
            drawLayers(gl, scene, blended, eye, step, isOneSided);
            program.use(gl);
            scene.mesh.bind(gl);
        }
        if (style.wireframe()) drawEdges(gl, scene, isOneSided);
        end(gl);
    }

    /** Fills the depth alone. */
    void drawDepth(GL3 gl, GpuScene scene, int step, Eye eye) {
        begin(gl, scene, step, eye);
        program.set(gl, "shading", Shading.MATERIALS.ordinal());
        scene.mesh.usePlaces(gl);
        int[] groups = scene.shown().groups;
        for (int g = 0; g < groups.length; g += 3) drawRun(gl, scene, groups, g, true, false);
        end(gl);
    }

    private void begin(GL3 gl, GpuScene scene, int step, Eye eye) {
        surface.upload(gl, scene.shown());
        gl.glEnable(GL.GL_DEPTH_TEST);
        gl.glDepthFunc(GL.GL_LEQUAL);
        gl.glCullFace(GL.GL_BACK);
        program.use(gl);
        program.set(gl, "view", eye.view());
        program.set(gl, "projection", eye.projection());
        program.set(gl, "step", step < 0 ? NO_STEP : step);
        program.set(gl, "levels", LEVELS_UNIT);
        program.set(gl, "edges", EDGE_COLOUR);
        for (int i = 0; i < Palette.size(); i++) program.set(gl, "palette[" + i + "]", Palette.stop(i));
        light(gl);
        scene.mesh.bind(gl);
    }

    private static void end(GL3 gl) {
        gl.glDisable(GL.GL_CULL_FACE);
        gl.glDisable(GL.GL_DEPTH_TEST);
        gl.glBindVertexArray(0);
        gl.glUseProgram(0);
        GpuStudio.unbind(gl, LIGHT_UNIT, REFLECTANCES_UNIT);
        GpuLevels.unbind(gl, LEVELS_UNIT);
        Surface.unbind(gl);
    }

    /** From outside, no face of a solid is seen from behind, but where a rounding error turns it. */
    private boolean isSolidSeenFrom(Eye eye, ShownScene scene) {
        return scene.isClosed
                && eye.isOutside()
                && scene.slots.materials().stream().allMatch(surface::isSolid);
    }

    private boolean isBlended(ShownScene scene, int slot) {
        return surface.isTranslucent(scene.slots.materials().get(slot));
    }

    private int[] blended(ShownScene scene) {
        int[] found = new int[scene.groups.length];
        int n = 0;
        for (int g = 0; g < found.length; g += 3) {
            if (!isBlended(scene, scene.groups[g])) continue;
            System.arraycopy(scene.groups, g, found, n, 3);
            n += 3;
        }
        return Arrays.copyOf(found, n);
    }

    /** Where the graphics card cannot blend pixel by pixel. What lets light through has no depth of its own. */
    private void drawSorted(GL3 gl, GpuScene scene, int[] groups, double[] view, boolean isOneSided) {
        int[] runs = scene.sort(gl, groups, view);
        scene.mesh.useSorted(gl);
        blend(gl);
        gl.glDepthMask(false);
        for (int r = 0; r < runs.length; r += 3) drawRun(gl, scene, runs, r, true, isOneSided);
        gl.glDepthMask(true);
        gl.glDisable(GL.GL_BLEND);
    }

    private void drawLayers(GL3 gl, GpuScene scene, int[] blended, Eye eye, int step, boolean isOneSided) {
        int[] viewport = new int[4];
        gl.glGetIntegerv(GL.GL_VIEWPORT, viewport, 0);
        int[] groups = scene.shown().groups;
        layers.draw(gl, viewport, eye, step, new Layers.Faces() {
            @Override
            public void drawOpaque() {
                for (int g = 0; g < groups.length; g += 3)
                    if (!isBlended(scene.shown(), groups[g])) drawRun(gl, scene, groups, g, true, isOneSided);
            }

            @Override
            public void drawPlain() {
                for (int g = 0; g < blended.length; g += 3) drawFaces(gl, scene, blended, g, isOneSided);
            }

            @Override
            public void drawColoured() {
                program.use(gl);
                for (int g = 0; g < blended.length; g += 3) drawRun(gl, scene, blended, g, true, isOneSided);
            }
        });
    }

    private void drawEdges(GL3 gl, GpuScene scene, boolean isOneSided) {
        program.set(gl, "shading", EDGES);
        gl.glPolygonMode(GL.GL_FRONT_AND_BACK, GL2GL3.GL_LINE);
        blend(gl);
        gl.glDepthMask(false);
        scene.mesh.usePlaces(gl);
        int[] groups = scene.shown().groups;
        for (int g = 0; g < groups.length; g += 3) drawRun(gl, scene, groups, g, false, isOneSided);
        gl.glDepthMask(true);
        gl.glDisable(GL.GL_BLEND);
        gl.glPolygonMode(GL.GL_FRONT_AND_BACK, GL2GL3.GL_FILL);
    }

    private static void blend(GL3 gl) {
        gl.glEnable(GL.GL_BLEND);
        gl.glBlendFunc(GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA);
    }

    private void drawRun(GL3 gl, GpuScene scene, int[] runs, int run, boolean isLit, boolean isOneSided) {
        if (runs[run + 2] == 0) return;
        if (isLit) surface.set(gl, program, material(scene, runs[run]));
        else program.set(gl, "firstPlace", runs[run + 1] / 3);
        drawFaces(gl, scene, runs, run, isOneSided);
    }

    private static DisplayMaterial material(GpuScene scene, int slot) {
        return scene.shown().slots.materials().get(slot);
    }

    /** With whatever program is in use. */
    private static void drawFaces(GL3 gl, GpuScene scene, int[] runs, int run, boolean isOneSided) {
        DisplayMaterial material = material(scene, runs[run]);
        if (material.doubleSided() && !isOneSided) gl.glDisable(GL.GL_CULL_FACE);
        else gl.glEnable(GL.GL_CULL_FACE);
        scene.mesh.draw(gl, runs[run + 1], runs[run + 2]);
    }

    private void light(GL3 gl) {
        program.set(gl, "sky", Lighting.SKY);
        program.set(gl, "ground", Lighting.GROUND);
        program.set(gl, "keyDirection", Lighting.KEY_DIRECTION);
        program.set(gl, "keyLight", Lighting.KEY);
        program.set(gl, "exposure", Lighting.EXPOSURE);
        Surface.giveUnits(gl, program);
        studio.bind(gl, program, LIGHT_UNIT, REFLECTANCES_UNIT);
    }

    void dispose(GL3 gl) {
        program.dispose(gl);
        if (layers != null) layers.dispose(gl);
        studio.dispose(gl);
        surface.dispose(gl);
    }
}
