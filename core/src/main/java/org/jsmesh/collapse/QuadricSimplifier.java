package org.jsmesh.collapse;

import java.util.Arrays;
import java.util.concurrent.Executor;
import org.jsmesh.level.LevelSchedule;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.patch.PatchLog;

/**
 * The default simplifier: half-edge collapses in passes, cheapest first by {@link org.jsmesh.weight.MemorylessQuadric}, within levels of growing thresholds.
 *
 * <p>Every vertex keeps its cheapest possible collapse. A pass takes those up to the level's threshold, and up to the cost at a rank that lets no pass
 * eat too far into costs which the collapses before it would have changed. A vertex is skipped when a neighbour was removed in this pass, so the stars of the vertices
 * of a pass share no face. Only vertices whose surroundings changed get new costs.
 *
 * <p>The result is the same for any number of threads.
 */
public final class QuadricSimplifier {
    /** A pass goes up to the cost at this share of the vertices. More would raise the error, less would cost more bytes per vertex. */
    private static final double PASS_SHARE = 0.5;

    /** The same while most vertices are there: collapses are so cheap then that large passes do no harm. */
    private static final double FINE_SHARE = 1.0;

    private static final double FINE_PART = 0.7;

    /** Below this share of the vertices the error of the shape counts for more than the bits of its positions. */
    private static final double COARSE_PART = 0.25;

    /** A level is exhausted when its threshold leaves less than this share of the vertices to a pass. */
    private static final double LEAST_SHARE = 0.3;

    /** Added to costs, so that those that cost nothing are ordered as well. */
    private static final double TINY = 1e-18;

    private static final String STAGE = "simplifying";
    private static final int BLOCK = 1 << 17;

    private final CollapseMesh mesh;
    private final SimplificationTarget target;
    private final ProgressListener progress;
    private final RangeRunner runner;
    private final CollapseFinder[] finders;
    private final double[] gatheredArea;
    private final int[] choice; // half-edge of the cheapest collapse of each vertex
    private final float[] cost;
    private final float[] rank; // order within a pass: cost times the distance from where a decoder expects the vertex
    private float[] sorted = new float[0]; // costs of the candidates
    private final int[] blocked; // pass in which the vertex or a neighbour was removed
    private final int[] live;
    private int liveCount;
    private int faces;
    private final int facesBefore;
    private final int verticesBefore;
    private int[] dirty;
    private int dirtyCount;
    private final boolean[] isDirty;
    private final int[] targets;
    private int targetCount;
    private long[] queue = new long[0];
    private LevelSchedule levels;

    private QuadricSimplifier(
            CollapseMesh mesh, SimplificationTarget target, ProgressListener progress, Executor executor, int threads) {
        this.mesh = mesh;
        this.target = target;
        this.progress = progress;
        runner = new RangeRunner(executor, threads);
        int vertices = mesh.table().vertices();
        UnitScale scale = new UnitScale(mesh);
        gatheredArea = scale.vertexAreas();
        finders = new CollapseFinder[threads];
        for (int i = 0; i < threads; i++) finders[i] = new CollapseFinder(mesh, scale.positions(), gatheredArea);
        choice = new int[vertices];
        cost = new float[vertices];
        rank = new float[vertices];
        blocked = new int[vertices];
        isDirty = new boolean[vertices];
        dirty = new int[vertices];
        targets = new int[vertices];
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
     * @throws java.util.concurrent.CancellationException when the listener cancels; the mesh is then to be thrown away
     */
    public static PatchLog simplify(
            CollapseMesh mesh, SimplificationTarget target, ProgressListener progress, Executor executor, int threads) {
        QuadricSimplifier run = new QuadricSimplifier(mesh, target, progress, executor, threads);
        run.run();
        return mesh.log();
    }

    /** The same with the calling thread alone. */
    public static PatchLog simplify(CollapseMesh mesh, SimplificationTarget target, ProgressListener progress) {
        return simplify(mesh, target, progress, Runnable::run, 1);
    }

    private void run() {
        markAllDirty();
        boolean complete = true; // every cost belongs to the mesh as it is
        while (!target.isReached(faces, liveCount)) {
            findCosts();
            int candidates = queueCandidates();
            if (candidates == 0) {
                if (complete) break;
                // a collapse may have become possible through changes further away than those that make a vertex dirty
                markAllDirty();
                complete = true;
                continue;
            }
            complete = false;
            if (levels == null) levels = new LevelSchedule(costs(candidates));
            runPass(candidates);
        }
        if (levels != null) mesh.log().setThresholds(levels.thresholds());
        progress.step(STAGE, 1);
    }

    private void markAllDirty() {
        dirtyCount = 0;
        for (int i = 0; i < liveCount; i++) markDirty(live[i]);
    }

    private void markDirty(int vertex) {
        if (isDirty[vertex]) return;
        isDirty[vertex] = true;
        dirty[dirtyCount++] = vertex;
    }

    private void findCosts() {
        boolean coarse = liveCount < COARSE_PART * verticesBefore;
        for (int from = 0; from < dirtyCount; from += BLOCK) {
            report();
            int start = from;
            runner.run(Math.min(BLOCK, dirtyCount - from), (worker, a, b) -> {
                CollapseFinder finder = finders[worker];
                for (int i = start + a; i < start + b; i++) {
                    int u = dirty[i];
                    isDirty[u] = false;
                    choice[u] = finder.find(u);
                    cost[u] = (float) finder.cost();
                    if (choice[u] != CollapseFinder.NONE)
                        rank[u] = (float)
                                ((finder.cost() + TINY) * (coarse ? Math.sqrt(finder.surprise()) : finder.surprise()));
                }
            });
        }
        dirtyCount = 0;
    }

    private void report() {
        progress.step(STAGE, (double) (facesBefore - faces) / Math.max(1, facesBefore - target.faces()));
    }

    /** Puts the vertices that can be removed in the queue, ordered by rank and id, and their costs in order. */
    private int queueCandidates() {
        if (queue.length < liveCount) {
            queue = new long[liveCount];
            sorted = new float[liveCount];
        }
        int n = 0;
        for (int i = 0; i < liveCount; i++) {
            int u = live[i];
            if (choice[u] != CollapseFinder.NONE) {
                sorted[n] = cost[u];
                queue[n++] = (long) Float.floatToRawIntBits(rank[u]) << 32 | u; // ranks are ≥ 0
            }
        }
        Arrays.sort(sorted, 0, n);
        Arrays.sort(queue, 0, n);
        return n;
    }

    private float costAt(int rank) {
        return sorted[rank];
    }

    private float[] costs(int candidates) {
        float[] costs = new float[candidates];
        for (int i = 0; i < candidates; i++) costs[i] = costAt(i);
        return costs;
    }

    private void runPass(int candidates) {
        double share = (liveCount > FINE_PART * verticesBefore ? FINE_SHARE : PASS_SHARE) * liveCount;
        levels.reach(costAt((int) Math.min(candidates - 1, LEAST_SHARE * liveCount)));
        double cap = Math.min(levels.threshold(), costAt((int) Math.min(candidates - 1, Math.ceil(share))));
        PatchLog log = mesh.log();
        log.beginPass(levels.level());
        int pass = log.passes();
        int start = log.size();
        targetCount = 0;
        for (int i = 0; i < candidates; i++) {
            int u = (int) queue[i];
            if (blocked[u] == pass || cost[u] > cap) continue;
            if (!finders[0].isStillCollapsible(choice[u])) {
                markDirty(u);
                continue;
            }
            collapse(u, pass);
            if (target.isReached(faces, liveCount - (log.size() - start))) break;
        }
        markTargetRings();
        dropRemoved();
        report();
    }

    private void collapse(int u, int pass) {
        VertexStar star = finders[0].star(); // of u, loaded by the test
        int h = choice[u];
        CornerTable t = mesh.table();
        int v = t.vertex(CornerTable.next(h));
        int left = CornerTable.face(h);
        int right = CornerTable.face(t.swingBack(h));
        faces -= (t.isDummy(left) ? 0 : 1) + (t.isDummy(right) ? 0 : 1);
        mesh.collapse(h);
        blocked[u] = pass;
        for (int i = 0; i < star.size; i++) {
            int x = star.neighbour[i];
            if (x == CornerTable.OUTSIDE) continue;
            blocked[x] = pass;
            markDirty(x);
        }
        gatheredArea[v] += gatheredArea[u];
        targets[targetCount++] = v;
    }

    private void markTargetRings() {
        CornerTable t = mesh.table();
        for (int i = 0; i < targetCount; i++) {
            int start = t.cornerOf(targets[i]);
            int c = start;
            do {
                int x = t.vertex(CornerTable.next(c));
                if (x != CornerTable.OUTSIDE) markDirty(x);
                c = t.swing(c);
            } while (c != start);
        }
    }

    private void dropRemoved() {
        CornerTable t = mesh.table();
        int n = 0;
        for (int i = 0; i < liveCount; i++) if (t.cornerOf(live[i]) >= 0) live[n++] = live[i];
        liveCount = n;
        int d = 0;
        for (int i = 0; i < dirtyCount; i++) {
            if (t.cornerOf(dirty[i]) >= 0) dirty[d++] = dirty[i];
        }
        dirtyCount = d;
    }
}
