package org.jsmesh.collapse;

import java.util.concurrent.Executor;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.patch.PatchLog;

/**
 * The default simplifier: half-edge collapses in passes, cheapest first by
 * {@link org.jsmesh.collapse.MemorylessQuadric}, within levels of growing thresholds.
 *
 * <p>Every vertex keeps its cheapest possible collapse. A pass takes those up to the level's threshold, and up to the
 * cost at a rank. The rank keeps a pass from going too far into costs that its earlier collapses would have changed. A
 * vertex is skipped when a neighbour was removed in this pass, so the stars of the vertices of a pass share no face.
 * Only vertices whose surroundings changed get new costs.
 *
 * <p>The result is the same for any number of threads.
 */
public final class QuadricSimplifier {
    /**
     * A pass goes up to the cost at this share of the vertices. More would raise the error, less would cost more bytes
     * per vertex.
     */
    private static final double PASS_SHARE = 0.5;

    /**
     * The same for {@link Effort#MUCH}, where passes follow costs alone, and for the last few vertices, because each
     * one counts.
     */
    private static final double SMALL_SHARE = 0.2;

    private static final int FEW = 200;

    /** The same while most vertices are there, when collapses are so cheap that large passes do no harm. */
    private static final double FINE_SHARE = 1.0;

    private static final double FINE_PART = 0.7;

    /** Below this share of the vertices the error of the shape counts for more than the bits of its positions. */
    private static final double COARSE_PART = 0.25;

    /** A level is exhausted when its threshold leaves less than this share of the vertices to a pass. */
    private static final double LEAST_SHARE = 0.3;

    /** Added to costs, so that collapses that cost nothing are ordered as well. */
    private static final double TINY = 1e-18;

    static final String STAGE = "simplifying";
    private static final int BLOCK = 1 << 17;

    private final CollapseMesh mesh;
    private final SimplificationTarget target;
    private final Effort effort;
    private final ProgressListener progress;
    private final RangeRunner runner;
    private final CollapseFinder[] finders;
    private final float[] gatheredArea;
    private final int[] choice; // half-edge of the cheapest collapse of each vertex
    private final float[] cost;
    private final float[] rank; // order within a pass: cost times the distance from where a decoder expects the vertex
    private final int[] found; // pass before which the collapse was found
    private final int[] blocked; // pass in which the vertex or a neighbour was last removed
    private final boolean[] isStale; // something else has changed that may matter to the collapse
    private final int[] live;
    private final RankQueue queue = new RankQueue();
    private int liveCount;
    private int faces;
    private final int facesBefore;
    private final int verticesBefore;
    private LevelSchedule levels;
    private final ComponentRemoval components;

    QuadricSimplifier(
            CollapseMesh mesh,
            SimplificationTarget target,
            Effort effort,
            ProgressListener progress,
            Executor executor,
            int threads) {
        this.mesh = mesh;
        this.effort = effort;
        this.target = target;
        this.progress = progress;
        runner = new RangeRunner(executor, threads);
        int vertices = mesh.table().vertices();
        UnitScale scale = new UnitScale(mesh);
        gatheredArea = scale.vertexAreas();
        components = new ComponentRemoval(mesh, scale);
        finders = new CollapseFinder[threads];
        RemovedVertices removed = effort == Effort.MUCH
                ? new RemovedVertices(scale, gatheredArea, mesh.original().faces())
                : null;
        for (int i = 0; i < threads; i++) finders[i] = new CollapseFinder(mesh, scale, gatheredArea, removed, effort);
        choice = new int[vertices];
        cost = new float[vertices];
        rank = new float[vertices];
        found = new int[vertices];
        blocked = new int[vertices];
        isStale = new boolean[vertices];
        live = new int[vertices];
        for (int v = 0; v < vertices; v++) {
            if (mesh.table().cornerOf(v) >= 0) live[liveCount++] = v;
        }
        verticesBefore = liveCount;
        facesBefore = mesh.liveFaces();
        faces = facesBefore;
    }

    /**
     * Simplifies a mesh in place.
     *
     * @param executor runs the helpers; not used when {@code threads} is 1
     * @param threads that may work, the calling one included
     * @return the log of the mesh, with a pass for every pass made and the thresholds of its levels
     * @throws java.util.concurrent.CancellationException when the listener cancels; throw the mesh away then
     */
    public static PatchLog simplify(
            CollapseMesh mesh,
            SimplificationTarget target,
            Effort effort,
            ProgressListener progress,
            Executor executor,
            int threads) {
        if (mesh.isApart()) new SeparateTriangles(mesh, target, progress).simplify();
        else new QuadricSimplifier(mesh, target, effort, progress, executor, threads).run();
        return mesh.log();
    }

    /** The same with the calling thread alone. */
    public static PatchLog simplify(
            CollapseMesh mesh, SimplificationTarget target, Effort effort, ProgressListener progress) {
        return simplify(mesh, target, effort, progress, Runnable::run, 1);
    }

    void run() {
        float limit = Float.POSITIVE_INFINITY; // of the costs that matter to the next pass
        boolean complete = true; // every collapse belongs to the mesh as it is
        markAllStale();
        long visits = LevelSchedule.visits(verticesBefore);
        while (!target.isReached(faces, liveCount) && visits > 0) {
            visits -= liveCount;
            findCollapses(limit);
            int candidates = 0;
            for (int i = 0; i < liveCount; i++) if (isCandidate(live[i])) candidates++;
            queue.clear(candidates);
            for (int i = 0; i < liveCount; i++) if (isCandidate(live[i])) queue.add(cost[live[i]]);
            int small = components.find(live, liveCount, u -> isStale[u] || choice[u] != CollapseFinder.NONE);
            boolean isSmaller = false;
            if (!queue.isEmpty()) {
                if (levels == null) levels = new LevelSchedule(queue.at(LevelSchedule.FIRST_PERCENTILE * queue.size()));
                levels.reach(queue.at(LEAST_SHARE * liveCount));
                float most = queue.at(Math.ceil(share() * liveCount));
                isSmaller = runPass((float) Math.min(levels.threshold(), most));
                if (effort == Effort.LITTLE) limit = most;
            } else if (small > 0) {
                if (levels == null) levels = new LevelSchedule(components.cheapest());
                levels.reach(components.cheapest());
                isSmaller = runPass(0);
            }
            if (!isSmaller) {
                if (complete) break;
                // a collapse may have become possible through changes further away than those that make a vertex stale
                markAllStale();
                limit = Float.POSITIVE_INFINITY;
            }
            complete = !isSmaller;
        }
        if (levels != null) mesh.log().setThresholds(levels.thresholds());
        progress.step(STAGE, 1);
    }

    private void markAllStale() {
        for (int i = 0; i < liveCount; i++) isStale[live[i]] = true;
    }

    private boolean isStale(int u) {
        return isStale[u] || blocked[u] >= found[u];
    }

    private boolean isCandidate(int u) {
        return !isStale(u) && choice[u] != CollapseFinder.NONE;
    }

    /**
     * Finds the collapses of stale vertices. Leaves out those that cost more than the limit so far, because they seldom
     * become cheaper.
     */
    private void findCollapses(float limit) {
        boolean coarse = liveCount < COARSE_PART * verticesBefore;
        int next = mesh.log().passes() + 1;
        for (int from = 0; from < liveCount; from += BLOCK) {
            report();
            int start = from;
            runner.run(Math.min(BLOCK, liveCount - from), (worker, a, b) -> {
                CollapseFinder finder = finders[worker];
                for (int i = start + a; i < start + b; i++) {
                    int u = live[i];
                    if (!isStale(u) || cost[u] > limit) continue;
                    isStale[u] = false;
                    found[u] = next;
                    choice[u] = finder.find(u);
                    cost[u] = choice[u] == CollapseFinder.NONE ? 0 : (float) finder.cost();
                    if (choice[u] != CollapseFinder.NONE) rank[u] = rank(finder, coarse);
                }
            });
        }
    }

    private float rank(CollapseFinder finder, boolean coarse) {
        double cost = finder.cost() + TINY;
        if (effort == Effort.MUCH) return (float) cost;
        return (float) (cost * (coarse ? Math.sqrt(finder.surprise()) : finder.surprise()));
    }

    private void report() {
        progress.step(STAGE, (double) (facesBefore - faces) / Math.max(1, facesBefore - target.faces()));
    }

    /**
     * Removes components up to the level's threshold, and collapses what costs no more. Returns false when there was
     * nothing.
     */
    private boolean runPass(float most) {
        queue.clear(queue.size()); // which were candidates then, too
        for (int i = 0; i < liveCount; i++) {
            int u = live[i];
            if (isCandidate(u) && cost[u] <= most) queue.add(rank[u], u);
        }
        queue.sort();
        PatchLog log = mesh.log();
        log.beginPass(levels.level());
        int pass = log.passes();
        int start = log.size();
        int[] gone = components.remove(levels.threshold(), target, faces, liveCount, blocked, pass);
        faces -= gone[0];
        for (int i = 0; i < queue.size(); i++) {
            int u = queue.id(i);
            if (blocked[u] == pass) continue;
            int v = mesh.table().vertex(CornerTable.next(choice[u]));
            if (!finders[0].isStillCollapsible(choice[u], blocked[v] >= found[u])) {
                isStale[u] = true;
                continue;
            }
            collapse(u, v, pass);
            if (target.isReached(faces, liveCount - gone[1] - (log.size() - start))) break;
        }
        dropRemoved();
        report();
        return log.size() > start || gone[1] > 0;
    }

    private double share() {
        if (effort == Effort.MUCH || liveCount < FEW) return SMALL_SHARE;
        return effort == Effort.LITTLE || liveCount > FINE_PART * verticesBefore ? FINE_SHARE : PASS_SHARE;
    }

    private void collapse(int u, int v, int pass) {
        VertexStar star = finders[0].star(); // of u, loaded by the test
        int h = choice[u];
        CornerTable t = mesh.table();
        int left = CornerTable.face(h);
        int right = CornerTable.face(t.swingBack(h));
        faces -= (t.isDummy(left) ? 0 : 1) + (t.isDummy(right) ? 0 : 1);
        finders[0].collapse(h);
        blocked[u] = pass;
        for (int i = 0; i < star.size; i++) {
            int x = star.neighbour[i];
            if (x == CornerTable.OUTSIDE) continue;
            blocked[x] = pass;
        }
        gatheredArea[v] += gatheredArea[u];
        if (effort != Effort.LITTLE) markRing(v); // otherwise the test fails when they are taken
    }

    /** Other collapses around a target may be possible now. */
    private void markRing(int v) {
        CornerTable t = mesh.table();
        int start = t.cornerOf(v);
        int c = start;
        do {
            int x = t.vertex(CornerTable.next(c));
            if (x != CornerTable.OUTSIDE) isStale[x] = true;
            c = t.swing(c);
        } while (c != start);
    }

    private void dropRemoved() {
        CornerTable t = mesh.table();
        int n = 0;
        for (int i = 0; i < liveCount; i++) if (t.cornerOf(live[i]) >= 0) live[n++] = live[i];
        liveCount = n;
    }
}
