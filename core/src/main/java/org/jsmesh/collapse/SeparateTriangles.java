package org.jsmesh.collapse;

import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.ProgressListener;

/**
 * Simplifies a mesh of triangles that all lie apart: a soup, or triangles about one edge. No collapse is possible, so
 * triangles go as a whole. The result is that of {@link QuadricSimplifier}, for which a vertex takes more than twice
 * the memory.
 */
final class SeparateTriangles {
    private final CollapseMesh mesh;
    private final SimplificationTarget target;
    private final ProgressListener progress;
    private final ComponentRemoval components;
    private final int[] live;
    private final int facesBefore;
    private int liveCount;
    private int faces;
    private LevelSchedule levels;

    SeparateTriangles(CollapseMesh mesh, SimplificationTarget target, ProgressListener progress) {
        this.mesh = mesh;
        this.target = target;
        this.progress = progress;
        components = new ComponentRemoval(mesh, new UnitScale(mesh));
        live = new int[mesh.table().vertices()];
        for (int v = 0; v < live.length; v++) if (mesh.table().cornerOf(v) >= 0) live[liveCount++] = v;
        facesBefore = mesh.liveFaces();
        faces = facesBefore;
    }

    /** Has no face a neighbour? */
    static boolean isAll(CollapseMesh mesh) {
        CornerTable t = mesh.table();
        int real = mesh.original().faces();
        for (int f = 0; f < real; f++) {
            if (!mesh.isLiveFace(f)) continue;
            int c = CornerTable.STRIDE * f;
            for (int j = c; j < c + 3; j++) if (CornerTable.face(t.swing(j)) < real) return false;
        }
        return true;
    }

    void simplify() {
        boolean complete = true;
        long visits = LevelSchedule.visits(liveCount);
        while (!target.isReached(faces, liveCount) && visits > 0) {
            visits -= liveCount;
            report();
            boolean isSmaller = false;
            if (components.find(live, liveCount, u -> false) > 0) {
                if (levels == null) levels = new LevelSchedule(components.cheapest());
                levels.reach(components.cheapest());
                isSmaller = runPass();
            }
            if (!isSmaller && complete) break;
            complete = !isSmaller;
        }
        if (levels != null) mesh.log().setThresholds(levels.thresholds());
        progress.step(QuadricSimplifier.STAGE, 1);
    }

    /** Returns false when nothing was removed. */
    private boolean runPass() {
        mesh.log().beginPass(levels.level());
        int[] gone = components.remove(
                levels.threshold(), target, faces, liveCount, null, mesh.log().passes());
        faces -= gone[0];
        int n = 0;
        for (int i = 0; i < liveCount; i++) if (mesh.table().cornerOf(live[i]) >= 0) live[n++] = live[i];
        liveCount = n;
        return gone[1] > 0;
    }

    private void report() {
        progress.step(
                QuadricSimplifier.STAGE, (double) (facesBefore - faces) / Math.max(1, facesBefore - target.faces()));
    }
}
