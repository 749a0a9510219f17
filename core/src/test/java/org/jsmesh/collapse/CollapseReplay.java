package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
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
                assertThat(mesh.isLiveFace(f))
                        .as("face %d of component %d", f, i)
                        .isTrue();
                for (int c = CornerTable.STRIDE * f; c < CornerTable.STRIDE * f + 3; c++) {
                    int beside = CornerTable.face(mesh.table().swing(c));
                    if (!mesh.table().isDummy(beside) && faces.add(beside)) found.add(beside);
                    vertices.add(mesh.table().vertex(c));
                }
            }
            next = found;
        }
        for (int p = log.passStart(pass); p < log.passStart(pass + 1); p++)
            assertThat(vertices).as("vertices of component %d", i).doesNotContain(log.removed(p), log.kept(p));
        mesh.removeComponent(array(faces), faces.size(), array(vertices), vertices.size());
        assertThat(mesh.liveFaces()).as("faces left").isPositive();
    }

    private static int[] array(Set<Integer> set) {
        return set.stream().mapToInt(n -> n).toArray();
    }

    private void collapse(int p) {
        CornerTable t = mesh.table();
        int u = log.removed(p);
        int v = log.kept(p);
        String what = "patch " + p + ", " + u + " into " + v;
        int h = -1;
        for (int c : corners(u)) if (t.vertex(CornerTable.next(c)) == v) h = c;
        assertThat(h).as("%s: there is such an edge", what).isNotNegative();
        int left = CornerTable.face(h);
        int right = CornerTable.face(t.swingBack(h));
        assertThat(new int[] {left, right}).as(what).containsExactly(log.leftFace(p), log.rightFace(p));
        checkLink(u, v, t.vertex(CornerTable.previous(h)), t.vertex(CornerTable.next(t.swingBack(h))), what);
        List<Integer> run = new ArrayList<>();
        for (int c : corners(u)) {
            int f = CornerTable.face(c);
            if (f != left && f != right && !t.isDummy(f)) run.add(f);
        }
        List<double[]> normals = run.stream().map(this::normal).toList();
        mesh.collapse(h);
        for (int i = 0; i < run.size(); i++) checkFace(run.get(i), v, normals.get(i), what);
    }

    /** Common neighbours of u and v are exactly the apexes of the faces on their edge; outside counts as one. */
    private void checkLink(int u, int v, int x, int y, String what) {
        Set<Integer> common = neighbours(u);
        common.retainAll(neighbours(v));
        assertThat(common).as("%s: link condition", what).containsExactlyInAnyOrder(x, y);
        assertThat(x).as("%s: apexes", what).isNotEqualTo(y);
    }

    private void checkFace(int face, int v, double[] before, String what) {
        Set<Integer> vertices = vertices(face);
        assertThat(vertices)
                .as("%s: vertices of face %d", what, face)
                .hasSize(3)
                .contains(v);
        for (int c : corners(v)) {
            int other = CornerTable.face(c);
            if (other != face)
                assertThat(vertices(other))
                        .as("%s: faces %d and %d", what, face, other)
                        .isNotEqualTo(vertices);
        }
        checkWedges(face);
        double[] after = normal(face);
        double length = length(after);
        double least = 2 * LEAST_AREA * (1 - ROUNDING) * diagonal * diagonal;
        assertThat(length).as("%s: twice the area of face %d", what, face).isGreaterThan(least);
        double old = length(before);
        if (old <= least) return; // it had no direction
        double cosine = (before[0] * after[0] + before[1] * after[1] + before[2] * after[2]) / (old * length);
        assertThat(cosine).as("%s: turn of face %d", what, face).isGreaterThan(leastCosine - ROUNDING);
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
        assertThat(start).as("a corner of vertex %d", vertex).isNotNegative();
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
