package org.jsmesh.collapse;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.patch.PatchLog;
import org.jsmesh.test.CornerTableValidator;

/**
 * Makes the collapses of a log once more on the original, and fails at the first that leaves no valid mesh: one that
 * breaks the link condition, or makes a face twice, turns it over, leaves it without area, or gives it a wedge of
 * another vertex. All of this is found from the faces about both vertices, with nothing of what the simplifiers use to
 * test it.
 */
final class CollapseReplay {
    /** Of a face that a collapse makes, in squared diagonals. */
    private static final double LEAST_AREA = 1e-14;

    private static final double ROUNDING = 1e-6;

    private final CollapseMesh mesh;
    private final CollapseMesh simplified;
    private final PatchLog log;
    private final double leastCosine;
    private final double diagonal;

    /**
     * @param simplified with its log
     * @param leastCosine between a face that a collapse makes and the same face before
     */
    CollapseReplay(CollapseMesh simplified, double leastCosine) {
        mesh = new CollapseMesh(simplified.original());
        this.simplified = simplified;
        log = simplified.log();
        this.leastCosine = leastCosine;
        float[] b = simplified.original().bounds();
        diagonal = Math.sqrt(square(b[3] - b[0]) + square(b[4] - b[1]) + square(b[5] - b[2]));
    }

    /** Words are put together only for what is wrong: there are millions of checks. */
    private static void check(boolean condition, String wrong, Object... values) {
        if (!condition) throw new AssertionError(String.format(Locale.ROOT, wrong, values));
    }

    private static double square(double x) {
        return x * x;
    }

    /** @param afterEveryCollapse look at the whole mesh after every collapse, not after every pass alone */
    void run(boolean afterEveryCollapse) {
        checkWhole();
        for (int pass = 0; pass < log.passes(); pass++) {
            for (int p = log.passStart(pass); p < log.passStart(pass + 1); p++) {
                collapse(p);
                if (afterEveryCollapse) checkWhole();
            }
            for (int i = log.componentStart(pass); i < log.componentStart(pass + 1); i++) removeComponent(i, pass);
            if (!afterEveryCollapse) checkWhole();
        }
        checkSameAsSimplified();
    }

    /** A component that no patch of its pass has touched goes, and something is left. */
    private void removeComponent(int i, int pass) {
        Set<Integer> faces = new LinkedHashSet<>(List.of(log.componentFace(i)));
        Set<Integer> vertices = new LinkedHashSet<>();
        for (List<Integer> next = List.copyOf(faces); !next.isEmpty(); ) {
            List<Integer> found = new ArrayList<>();
            for (int f : next) {
                check(mesh.isLiveFace(f), "face %d of component %d is gone", f, i);
                for (int c = CornerTable.STRIDE * f; c < CornerTable.STRIDE * f + 3; c++) {
                    int beside = CornerTable.face(mesh.table().swing(c));
                    if (!mesh.table().isDummy(beside) && faces.add(beside)) found.add(beside);
                    vertices.add(mesh.table().vertex(c));
                }
            }
            next = found;
        }
        for (int p = log.passStart(pass); p < log.passStart(pass + 1); p++)
            check(
                    !vertices.contains(log.removed(p)) && !vertices.contains(log.kept(p)),
                    "component %d has a vertex of patch %d",
                    i,
                    p);
        mesh.removeComponent(array(faces), faces.size(), array(vertices), vertices.size());
        check(mesh.liveFaces() > 0, "no face is left");
    }

    private static int[] array(Set<Integer> set) {
        return set.stream().mapToInt(n -> n).toArray();
    }

    private void collapse(int p) {
        CornerTable t = mesh.table();
        int u = log.removed(p);
        int v = log.kept(p);
        int h = -1;
        for (int c : corners(u)) if (t.vertex(CornerTable.next(c)) == v) h = c;
        check(h >= 0, "patch %d: no edge leads from %d to %d", p, u, v);
        int left = CornerTable.face(h);
        int right = CornerTable.face(t.swingBack(h));
        check(
                left == log.leftFace(p) && right == log.rightFace(p),
                "patch %d: faces %d and %d are at its edge",
                p,
                left,
                right);
        checkLink(p, t.vertex(CornerTable.previous(h)), t.vertex(CornerTable.next(t.swingBack(h))));
        List<Integer> run = new ArrayList<>();
        for (int c : corners(u)) {
            int f = CornerTable.face(c);
            if (f != left && f != right && !t.isDummy(f)) run.add(f);
        }
        List<double[]> normals = run.stream().map(this::normal).toList();
        mesh.collapse(h);
        for (int i = 0; i < run.size(); i++) checkFace(p, run.get(i), normals.get(i));
    }

    /** Common neighbours of u and v are exactly the apexes of the faces on their edge; outside counts as one. */
    private void checkLink(int p, int x, int y) {
        Set<Integer> common = neighbours(log.removed(p));
        common.retainAll(neighbours(log.kept(p)));
        check(
                x != y && common.size() == 2 && common.contains(x) && common.contains(y),
                "patch %d: common neighbours are %s, apexes %d and %d",
                p,
                common,
                x,
                y);
    }

    private void checkFace(int p, int face, double[] before) {
        int v = log.kept(p);
        Set<Integer> vertices = vertices(face);
        check(vertices.size() == 3 && vertices.contains(v), "patch %d: face %d has vertices %s", p, face, vertices);
        for (int c : corners(v)) {
            int other = CornerTable.face(c);
            check(other == face || !hasVertices(other, vertices), "patch %d: faces %d and %d are one", p, face, other);
        }
        checkWedges(face);
        double[] after = normal(face);
        double length = length(after);
        double least = 2 * LEAST_AREA * (1 - ROUNDING) * diagonal * diagonal;
        check(length > least, "patch %d: twice the area of face %d is %s", p, face, length);
        double old = length(before);
        if (old <= least) return; // it had no direction
        double cosine = (before[0] * after[0] + before[1] * after[1] + before[2] * after[2]) / (old * length);
        check(cosine > leastCosine - ROUNDING, "patch %d: the cosine of face %d's turn is %s", p, face, cosine);
    }

    private void checkWhole() {
        CornerTableValidator.validate(mesh.table());
        for (int f = 0; f < mesh.original().faces(); f++) if (mesh.isLiveFace(f)) checkWedges(f);
    }

    private void checkWedges(int face) {
        Mesh original = mesh.original();
        for (int c = CornerTable.STRIDE * face; c < CornerTable.STRIDE * face + 3; c++) {
            int owner = original.wedgeVertices()[mesh.wedge(c)];
            if (owner == mesh.vertexOf()[mesh.table().vertex(c)]) continue;
            throw new AssertionError("face " + face + " has a wedge of vertex " + owner + " at vertex "
                    + mesh.table().vertex(c));
        }
        if (mesh.material(face) != original.faceMaterials()[face])
            throw new AssertionError("face " + face + " has another material");
    }

    /** The log holds all that happened. */
    private void checkSameAsSimplified() {
        for (int f = 0; f < mesh.original().faces(); f++) {
            boolean live = mesh.isLiveFace(f);
            if (live != simplified.isLiveFace(f)) throw new AssertionError("face " + f + " is not in both");
            for (int c = CornerTable.STRIDE * f; live && c < CornerTable.STRIDE * f + 3; c++) {
                if (mesh.table().vertex(c) != simplified.table().vertex(c) || mesh.wedge(c) != simplified.wedge(c))
                    throw new AssertionError("corner " + c + " differs");
            }
        }
    }

    /** Corners about a vertex, one in each face. */
    private List<Integer> corners(int vertex) {
        List<Integer> list = new ArrayList<>();
        int start = mesh.table().cornerOf(vertex);
        check(start >= 0, "vertex %d has no corner", vertex);
        int c = start;
        do {
            list.add(c);
            c = mesh.table().swing(c);
        } while (c != start);
        return list;
    }

    private Set<Integer> neighbours(int vertex) {
        Set<Integer> set = new HashSet<>();
        for (int c : corners(vertex)) {
            set.add(mesh.table().vertex(CornerTable.next(c)));
            set.add(mesh.table().vertex(CornerTable.previous(c)));
        }
        return set;
    }

    private boolean hasVertices(int face, Set<Integer> vertices) {
        for (int c = CornerTable.STRIDE * face; c < CornerTable.STRIDE * face + 3; c++)
            if (!vertices.contains(mesh.table().vertex(c))) return false;
        return vertices(face).size() == vertices.size();
    }

    private Set<Integer> vertices(int face) {
        Set<Integer> set = new HashSet<>();
        for (int c = CornerTable.STRIDE * face; c < CornerTable.STRIDE * face + 3; c++)
            set.add(mesh.table().vertex(c));
        return set;
    }

    /** Of twice the area in length. */
    private double[] normal(int face) {
        int c = CornerTable.STRIDE * face;
        double[] a = side(c, c + 1);
        double[] b = side(c, c + 2);
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private double[] side(int from, int to) {
        double[] d = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            d[axis] = (double) mesh.position(mesh.table().vertex(to), axis)
                    - mesh.position(mesh.table().vertex(from), axis);
        }
        return d;
    }

    private static double length(double[] n) {
        return Math.sqrt(square(n[0]) + square(n[1]) + square(n[2]));
    }
}
