package org.jsmesh.collapse;

import org.jsmesh.mesh.CornerTable;

/** Finds the cheapest collapse of a vertex that passes all tests. One per thread: it only reads the mesh. */
final class CollapseFinder {
    /** No collapse. */
    static final int NONE = -1;

    /** Cosine between the old and the new normal of a face. */
    private static final double LEAST_COSINE = 0.2;

    private static final int SLOT = 63;

    private final CollapseMesh mesh;
    private final float[] gatheredArea;
    private final RemovedVertices removed;
    private final Effort effort;
    private final FanDistance fan = new FanDistance();
    private final VertexStar star;
    private final TopologyTest topology;
    private final FlipTest flip = new FlipTest(LEAST_COSINE);
    private final MemorylessQuadric quadric = new MemorylessQuadric();
    private final double[] costs = new double[VertexStar.MOST_FACES + 1];
    private final double[] feature = new double[VertexStar.MOST_FACES + 1];
    private double cost;

    /**
     * @param gatheredArea original area gathered in each vertex
     * @param removed for {@link Effort#MUCH}, else null
     */
    CollapseFinder(CollapseMesh mesh, UnitScale scale, float[] gatheredArea, RemovedVertices removed, Effort effort) {
        this.mesh = mesh;
        this.gatheredArea = gatheredArea;
        this.removed = removed;
        this.effort = effort;
        star = new VertexStar(mesh, scale);
        topology = new TopologyTest(mesh);
    }

    /** The star last looked at. */
    VertexStar star() {
        return star;
    }

    /** Cost of the collapse last found. */
    double cost() {
        return cost;
    }

    /**
     * Distance of the vertex last looked at from where a decoder expects it: the mean of its neighbours, at a boundary
     * the mean of the two neighbours along it.
     */
    double surprise() {
        double x = 0;
        double y = 0;
        double z = 0;
        int n = 0;
        for (int i = 0; i < star.size; i++) {
            boolean counts = star.boundary
                    ? star.neighbour[i == 0 ? star.size - 1 : i - 1] == CornerTable.OUTSIDE
                            || star.neighbour[i + 1 == star.size ? 0 : i + 1] == CornerTable.OUTSIDE
                    : true;
            if (!counts || star.neighbour[i] == CornerTable.OUTSIDE) continue;
            x += star.edge[3 * i];
            y += star.edge[3 * i + 1];
            z += star.edge[3 * i + 2];
            n++;
        }
        return Math.sqrt(x * x + y * y + z * z) / n;
    }

    /** The half-edge (corner of u) of the cheapest possible collapse that removes u, or {@link #NONE}. */
    int find(int u) {
        if (!star.load(u)) return NONE;
        star.findSharpEdges();
        // 0: anywhere. 2: along the feature. Otherwise features end or branch here; the vertex may go along one of
        // them, unless charts of a texture would mix.
        if (star.sharpEdges != 0 && star.sharpEdges != 2 && mesh.hasTexture()) return NONE;
        star.measure(u);
        int candidates = findCosts(u);
        if (candidates > 0) topology.setRemoved(star);
        int best = NONE;
        cost = Double.POSITIVE_INFINITY;
        for (; candidates > 0; candidates--) {
            int i = cheapest();
            double planes = costs[i];
            if (planes >= cost) break; // distances only add to that
            costs[i] = Double.POSITIVE_INFINITY;
            if (!topology.isCollapsible(star, i) || !flip.keepsOrientation(star, i)) continue;
            double all = planes + distances(u, i, cost - planes);
            if (all >= cost) continue;
            cost = all;
            best = star.corner[i];
        }
        return best;
    }

    /** Adds what planes miss: how far removed vertices would be from what is left. */
    private double distances(int u, int target, double limit) {
        if (effort == Effort.LITTLE) return 0;
        fan.set(star, target);
        if (removed != null) return removed.cost(star, u, fan, limit);
        return RemovedVertices.WEIGHT * gatheredArea[u] * fan.squared(0, 0, 0);
    }

    /** Collapses along h; its vertex is the one last looked at. */
    void collapse(int h) {
        if (removed != null) {
            int u = mesh.table().vertex(h);
            int i = 0;
            while (star.corner[i] != h) i++;
            star.measure(u);
            fan.set(star, i);
            removed.collapse(star, u, fan);
        }
        mesh.collapse(h);
    }

    /**
     * Is the collapse along h still possible? It was found earlier, and the star of its vertex has not changed since.
     * Loads the star.
     *
     * @param isTargetTouched whether anything about the target has changed
     */
    boolean isStillCollapsible(int h, boolean isTargetTouched) {
        star.load(mesh.table().vertex(h));
        if (!isTargetTouched) return true;
        star.findSharpEdges();
        topology.setRemoved(star);
        int i = 0;
        while (star.corner[i] != h) i++;
        return topology.isCollapsible(star, i);
    }

    /** Fills {@link #costs} and returns how many are finite. A cost is infinite where the target is not possible. */
    private int findCosts(int u) {
        VertexStar s = star;
        quadric.clear();
        for (int i = 0; i < s.size; i++) {
            double length = s.normalLength[i];
            if (length > 0) quadric.addFace(s.normal[3 * i], s.normal[3 * i + 1], s.normal[3 * i + 2], length);
        }
        int features = findFeatures();
        int candidates = 0;
        for (int i = 0; i < s.size; i++) {
            costs[i] = Double.POSITIVE_INFINITY;
            if (!s.mayCollapseAlong(i)) continue;
            double dx = s.edge[3 * i];
            double dy = s.edge[3 * i + 1];
            double dz = s.edge[3 * i + 2];
            double c = quadric.cost(dx, dy, dz, gatheredArea[u]);
            if (features > 0) c += featureCost(i, dx, dy, dz);
            costs[i] = c;
            candidates++;
        }
        return candidates;
    }

    /**
     * Finds out which edges of the star are features, and how much: sharp edges fully, edges where the surface folds
     * back by the cosine. The planes of a folded fin do not hold back moves within it.
     */
    private int findFeatures() {
        VertexStar s = star;
        int found = 0;
        for (int i = 0; i < s.size; i++) {
            feature[i] = s.sharp[i] ? 1 : foldedBack(i == 0 ? s.size - 1 : i - 1, i);
            if (feature[i] > 0) found++;
        }
        return found;
    }

    private double foldedBack(int f, int g) {
        double lengths = star.normalLength[f] * star.normalLength[g];
        if (lengths == 0) return 0;
        double[] n = star.normal;
        double dot = n[3 * f] * n[3 * g] + n[3 * f + 1] * n[3 * g + 1] + n[3 * f + 2] * n[3 * g + 2];
        return dot < 0 ? -dot / lengths : 0;
    }

    private double featureCost(int target, double dx, double dy, double dz) {
        double[] e = star.edge;
        double c = 0;
        for (int i = 0; i < star.size; i++) {
            if (i == target || feature[i] == 0) continue;
            c += feature[i] * MemorylessQuadric.featureCost(e[3 * i], e[3 * i + 1], e[3 * i + 2], dx, dy, dz);
        }
        return c;
    }

    /**
     * The neighbour of least cost, of several the lowest. The loop has no branches that a processor would predict
     * wrongly.
     */
    private int cheapest() {
        long least = Long.MAX_VALUE;
        for (int i = 0; i < star.size; i++)
            least = Math.min(least, Double.doubleToRawLongBits(costs[i]) & ~SLOT | i); // costs are ≥ 0
        int best = (int) least & SLOT;
        for (int i = best + 1; i < star.size; i++)
            if (costs[i] == costs[best] && star.neighbour[i] < star.neighbour[best]) best = i;
        return best;
    }
}
