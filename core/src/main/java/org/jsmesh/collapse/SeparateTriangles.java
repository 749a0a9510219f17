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
        mesh.separate();
        this.target = target;
        this.progress = progress;
        components = new ComponentRemoval(mesh, new UnitScale(mesh));
        live = new int[mesh.table().vertices()];
        for (int v = 0; v < live.length; v++) if (mesh.table().cornerOf(v) >= 0) live[liveCount++] = v;
        facesBefore = mesh.liveFaces();
        faces = facesBefore;
    }

    /**
     * A table without dummy faces, where every corner swings to itself. It takes a quarter of the memory.
     *
     * @param corners vertex of corner 3 f + j; no vertex occurs twice
     */
    static CornerTable table(int[] corners, int vertices) {
        CornerTable table = new CornerTable(corners.length / 3, vertices);
        for (int v = 0; v < vertices; v++) table.setCornerOf(table.addVertex(), -1);
        for (int h = 0; h < corners.length; h++) {
            if (h % 3 == 0) table.addFace(corners[h], corners[h + 1], corners[h + 2]);
            int corner = CornerTable.STRIDE * (h / 3) + h % 3;
            table.setSwing(corner, corner);
            table.setCornerOf(corners[h], corner);
        }
        return table;
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
