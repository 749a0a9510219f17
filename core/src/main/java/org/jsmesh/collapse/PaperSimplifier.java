package org.jsmesh.collapse;

import java.util.List;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.patch.PatchLog;

/**
 * The simplification of Chen and Nishita 2002, sections 3 and 4: levels by ascending threshold, each until nothing in
 * it is removable. A level has passes over all {@link RemovableEdges}, lightest first.
 *
 * <p>An edge in the queue collapses onto its un-removable end, or onto the end where the surface bends more
 * ({@link NormalDeviation}). If that would turn a face over ({@link FlipTest}) or break the topology
 * ({@link TopologyTest}), it waits for the next pass. A vertex may receive any number of collapses in a pass, and then
 * be removed itself. The log has passes of its own, see {@link PassPlan}.
 *
 * <p>The paper leaves two choices. Weights are those of {@link ScalarAttributes}. A vertex of several fans is
 * un-removable as well.
 */
public final class PaperSimplifier {
    /**
     * Thresholds that bring fandisk and cessna of the paper's Table 1 within .4% of its faces and vertices. The paper
     * does not name its own.
     */
    public static final List<Double> DEFAULT_THRESHOLDS = List.of(0.15, 0.3, 0.4);

    /** A face may turn by anything less than a right angle. */
    private static final double LEAST_COSINE = 0;

    private static final String STAGE = "simplifying";
    private static final int REPORT_EVERY = 1 << 12; // edges

    /** Deviations that differ by less count as the same; the digits of positions cause such differences. */
    private static final double NOISE = 1e-7;

    private final CollapseMesh mesh;
    private final SimplificationTarget target;
    private final ProgressListener progress;
    private final ScalarAttributes attributes;
    private final RemovableEdges edges;
    private final NormalDeviation deviation;
    private final VertexStar star;
    private final TopologyTest topology;
    private final FlipTest flip = new FlipTest(LEAST_COSINE);
    private final PassPlan plan;
    private int faces;
    private int vertices;
    private int removable; // vertices, at the start
    private int removed;

    private PaperSimplifier(CollapseMesh mesh, SimplificationTarget target, ProgressListener progress) {
        this.mesh = mesh;
        this.target = target;
        this.progress = progress;
        progress.step(STAGE, 0);
        CornerTable t = mesh.table();
        attributes = new ScalarAttributes(mesh.original(), t);
        edges = new RemovableEdges(attributes, t, mesh.original().faces(), mesh::isLiveFace);
        UnitScale scale = new UnitScale(mesh);
        deviation = new NormalDeviation(mesh, scale);
        star = new VertexStar(mesh, scale);
        topology = new TopologyTest(mesh);
        plan = new PassPlan(mesh);
        faces = mesh.liveFaces();
        for (int v = 0; v < t.vertices(); v++) {
            if (t.cornerOf(v) < 0) continue;
            vertices++;
            if (mesh.isCut(v)) edges.lock(v);
            if (!edges.isLocked(v)) removable++;
        }
    }

    /**
     * Simplifies a mesh in place.
     *
     * @param thresholds of the weight, for each level, ascending
     * @return the log of the mesh
     * @throws java.util.concurrent.CancellationException when the listener cancels; throw the mesh away then
     */
    public static PatchLog simplify(
            CollapseMesh mesh, List<Double> thresholds, SimplificationTarget target, ProgressListener progress) {
        PaperSimplifier run = new PaperSimplifier(mesh, target, progress);
        for (int level = 0; level < thresholds.size(); level++) {
            run.plan.beginLevel(level);
            int before;
            do {
                before = run.removed;
                run.runPass(thresholds.get(level));
            } while (run.removed > before);
        }
        mesh.log()
                .setThresholds(
                        thresholds.stream().mapToDouble(Double::doubleValue).toArray());
        run.plan.arrange();
        progress.step(STAGE, 1);
        return mesh.log();
    }

    private void runPass(double threshold) {
        if (target.isReached(faces, vertices - removed)) return;
        edges.find(threshold);
        for (int place = 0; place < edges.size(); place++) {
            if (place % REPORT_EVERY == 0) progress.step(STAGE, (double) removed / Math.max(1, removable));
            takeEdge(edges.end(place), edges.otherEnd(place));
            if (target.isReached(faces, vertices - removed)) return;
        }
    }

    private void takeEdge(int a, int b) {
        CornerTable t = mesh.table();
        if (t.cornerOf(a) < 0 || t.cornerOf(b) < 0) return; // removed in this pass
        boolean aGoes = edges.isRemovable(a);
        boolean bGoes = edges.isRemovable(b);
        if (aGoes && bGoes) aGoes = deviation.of(a) <= deviation.of(b) + NOISE;
        if (aGoes) collapse(a, b);
        else if (bGoes) collapse(b, a);
    }

    /** Removes u into its neighbour v if it passes all tests. */
    private void collapse(int u, int v) {
        if (!star.load(u)) return;
        star.findSharpEdges();
        star.measure(u);
        topology.setRemoved(star);
        int i = 0;
        while (star.neighbour[i] != v) i++;
        if (!topology.isCollapsible(star, i) || !flip.keepsOrientation(star, i)) return;
        plan.add(star, i);
        int h = star.corner[i];
        for (int j = 0; j < star.size; j++) attributes.join(star.corner[j], CornerTable.next(h));
        mesh.collapse(h);
        faces -= 2; // no end of a boundary is removable
        removed++;
    }
}
