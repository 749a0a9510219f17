package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.test.CornerTableValidator;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;

class CollapseFinderTest {
    @Property(tries = 150, seed = "1")
    void shouldLeaveAManifoldAfterEveryCollapse(@ForAll RandomMeshes kind, @ForAll long seed) {
        CollapseMesh mesh = new CollapseMesh(kind.mesh(seed));
        CornerTable table = mesh.table();
        CornerTableValidator.validate(table);
        CollapseFinder finder = finder(mesh);
        Random random = new Random(seed);
        for (int i = 0; i < 3 * table.vertices(); i++) {
            int u = random.nextInt(table.vertices());
            if (table.cornerOf(u) < 0) continue;
            int h = finder.find(u);
            if (h == CollapseFinder.NONE) continue;
            int v = table.vertex(CornerTable.next(h));
            int left = table.vertex(CornerTable.previous(h));
            int right = table.vertex(CornerTable.next(table.swingBack(h)));
            mesh.collapse(h);
            CornerTableValidator.validate(table);
            assertThat(table.valence(v)).isBetween(3, 60);
            if (left != CornerTable.OUTSIDE) assertThat(table.valence(left)).isGreaterThanOrEqualTo(3);
            if (right != CornerTable.OUTSIDE) assertThat(table.valence(right)).isGreaterThanOrEqualTo(3);
        }
    }

    @Test
    void shouldNotCollapseATetrahedron() {
        assertNothingCollapses(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3);
    }

    @Test
    void shouldNotCollapseALoneTriangle() {
        assertNothingCollapses(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, 0, 1, 2);
    }

    @Test
    void shouldNotTurnAFaceOver() {
        // flat, so the shortest move is the cheapest, but vertex 1 lies behind the line through 2 and 3
        assertThat(targetInFlatStar(1, 0, 0.6f, 1, 0.5f, 3, -3, 1, -1, -3)).isEqualTo(2);
        assertThat(targetInFlatStar(1, 0, 1.6f, 1, 0.5f, 3, -3, 1, -1, -3)).isEqualTo(1);
    }

    @Test
    void shouldNotMakeAFaceWithoutArea() {
        assertThat(targetInFlatStar(0.6f, 0, 0.6f, 1, 0.6f, 3, -3, 1, -1, -3)).isEqualTo(2);
    }

    /** Where vertex 0 at the origin goes in a flat star of five faces about it. */
    private static int targetInFlatStar(float... ring) {
        float[] positions = new float[18];
        int[] faces = new int[15];
        for (int i = 0; i < 5; i++) {
            positions[3 * i + 3] = ring[2 * i];
            positions[3 * i + 4] = ring[2 * i + 1];
            faces[3 * i + 1] = i + 1;
            faces[3 * i + 2] = i == 4 ? 1 : i + 2;
        }
        CollapseMesh mesh = new CollapseMesh(mesh(positions, faces));
        return mesh.table().vertex(CornerTable.next(finder(mesh).find(0)));
    }

    @Test
    void shouldMoveABoundaryVertexAlongTheBoundaryOnly() {
        // a square with vertex 4 in the middle of its lower side
        Mesh mesh = mesh(new float[] {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 0, 0}, 0, 4, 3, 4, 2, 3, 4, 1, 2);
        CollapseMesh collapse = new CollapseMesh(mesh);
        int h = finder(collapse).find(4);
        assertThat(collapse.table().vertex(CornerTable.next(h))).isIn(0, 1);
    }

    @Test
    void shouldRemoveOneFanOfAVertexThatJoinsTwo() {
        Mesh mesh = mesh(
                new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 1, 1, 0, -1, -1, 0},
                0,
                1,
                5,
                0,
                5,
                2,
                0,
                3,
                6,
                0,
                6,
                4);
        CollapseMesh collapse = new CollapseMesh(mesh);
        assertThat(collapse.isCut(0)).isTrue();
        int h = finder(collapse).find(0);
        collapse.collapse(h);
        assertThat(collapse.liveFaces()).isEqualTo(3);
        int other = collapse.table().vertices() - 1;
        assertThat(collapse.vertexOf()[other]).isZero();
        assertThat(collapse.table().cornerOf(other)).isNotNegative();
    }

    private static void assertNothingCollapses(float[] positions, int... faces) {
        CollapseMesh mesh = new CollapseMesh(mesh(positions, faces));
        CollapseFinder finder = finder(mesh);
        for (int v = 0; v < mesh.table().vertices(); v++)
            assertThat(finder.find(v)).isEqualTo(CollapseFinder.NONE);
    }

    private static Mesh mesh(float[] positions, int... faces) {
        return new MeshBuilder().positions(positions).faceWedges(faces).build();
    }

    private static CollapseFinder finder(CollapseMesh mesh) {
        UnitScale scale = new UnitScale(mesh);
        return new CollapseFinder(mesh, scale, scale.vertexAreas(), null, Effort.SOME);
    }
}
