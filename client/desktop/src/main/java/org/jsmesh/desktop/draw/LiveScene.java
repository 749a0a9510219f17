package org.jsmesh.desktop.draw;

import com.jogamp.opengl.GL3;
import java.util.ArrayDeque;
import java.util.Deque;
import org.jsmesh.display.LiveStep;

/**
 * A scene that is refined step by step. A step goes to the graphics card in slices; until all of it is there, the
 * picture is that of the step before. Used by one thread at a time.
 */
public final class LiveScene {
    private static final int BYTES = 4;
    private static final int NO_STEP = -1;

    private final Deque<SceneStep> steps = new ArrayDeque<>();
    private ShownScene shown = new ShownScene();
    private RangeSlices slices; // of the first step, once it has begun
    private int roomless; // the first array for which there may be no room yet

    /** The next step; the first one of a mesh takes the place of all that was there. */
    public void take(SceneStep step) {
        if (step.live().number() == 1) {
            steps.clear();
            slices = null;
        }
        steps.add(step);
    }

    /** Whether all steps are shown. */
    public boolean isResting() {
        return steps.isEmpty();
    }

    /** The last level of the model; 0 before anything is known. */
    public int lastLevel() {
        return shown.lastLevel();
    }

    ShownScene shown() {
        return shown;
    }

    /** The step of which a part is there; its vertices stay where they start. −1 for none. */
    int unfinished() {
        return slices == null ? NO_STEP : steps.element().live().number();
    }

    /** Whether nothing can stay of the picture before when the next slice comes. */
    boolean beginsAnother() {
        return slices == null && !steps.isEmpty() && steps.element().live().number() == 1;
    }

    /**
     * Brings the next part to the graphics card. Of a step that would break the picture, all comes at once.
     *
     * @param bytes at most, else
     * @return whether a step is whole now, so that the picture is another
     */
    boolean advance(GL3 gl, GpuMesh mesh, long bytes) {
        SceneStep step = steps.peek();
        if (step == null) return false;
        LiveStep live = step.live();
        if (slices == null) begin(step);
        if (makesRoom(gl, mesh)) return false;
        boolean isAtOnce = live.number() == 1 || live.isJump();
        long left = isAtOnce ? Long.MAX_VALUE : Math.max(1, bytes / BYTES);
        while (left > 0 && slices.next((int) Math.min(left, Integer.MAX_VALUE))) {
            shown.arrays.write(slices.array(), slices.first(), live.data(), slices.at(), slices.count());
            mesh.reserve(gl, slices.array(), shown.arrays.bits(slices.array()).length);
            mesh.write(gl, slices.array(), slices.first(), live.data(), slices.at(), slices.count());
            left -= slices.count();
        }
        if (!slices.isOver()) return false;
        slices = null;
        steps.remove();
        shown.finish(step);
        step.taken().run();
        return true;
    }

    private void begin(SceneStep step) {
        slices = new RangeSlices(step.live());
        if (step.first() == null) return;
        shown = step.first();
        roomless = 0;
    }

    /**
     * Makes as much room in one buffer as its array has, so that little is copied later: some drivers fill it with
     * zeros, which takes long enough for one call.
     */
    private boolean makesRoom(GL3 gl, GpuMesh mesh) {
        for (; roomless < MeshArrays.COUNT; roomless++) {
            int[] bits = shown.arrays.bits(roomless);
            if (bits == null || !mesh.reserve(gl, roomless, bits.length)) continue;
            roomless++;
            return true;
        }
        return false;
    }
}
