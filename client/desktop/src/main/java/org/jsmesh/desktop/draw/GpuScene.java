package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL3;
import java.util.Arrays;
import org.jsmesh.desktop.gpu.GpuLevels;

/** A scene on the graphics card. Used on the thread that holds the context. */
final class GpuScene {
    final GpuMesh mesh;
    private final GpuLevels levels;
    private ShownScene shown;
    private boolean areLevelsThere;
    /** Translucent triangles in their order, and the view that they were sorted for. */
    private int[] runs = {};

    private double[] sortedFor;

    /** @param scene of which all is brought to the graphics card */
    GpuScene(GL3 gl, ShownScene scene) {
        mesh = new GpuMesh(gl);
        levels = new GpuLevels(gl);
        shown = scene;
        mesh.write(gl, scene.arrays);
    }

    ShownScene shown() {
        return shown;
    }

    /** Other arrays have been brought to the graphics card. */
    void changed(ShownScene now) {
        shown = now;
        sortedFor = null;
        areLevelsThere = false;
    }

    /**
     * Puts translucent triangles into the order in which they are to be drawn.
     *
     * @param groups of them
     * @param view matrix
     * @return runs of the sorted triangles with one material each
     */
    int[] sort(GL3 gl, int[] groups, double[] view) {
        if (!Arrays.equals(view, sortedFor)) {
            FarFirst.Order order = new FarFirst(shown.arrays, view).order(groups);
            mesh.sort(gl, order.indices());
            runs = order.runs();
            sortedFor = view;
        }
        return runs;
    }

    void bindLevels(GL3 gl, int unit) {
        if (!areLevelsThere) levels.upload(gl, shown.levels());
        areLevelsThere = true;
        levels.bind(gl, unit);
    }

    void dispose(GL3 gl) {
        mesh.dispose(gl);
        levels.dispose(gl);
    }
}
