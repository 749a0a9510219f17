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
            mesh.collapse(h);
            CornerTableValidator.validate(table);
            assertThat(table.valence(v)).isBetween(3, 60);
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
        // vertex 5 sits in a dent of the boundary of its star: most targets lie behind one of its edges
        Mesh mesh = mesh(
                new float[] {0, 0, 0, 4, 0, 0, 4, 4, 0, 1, 1, 0, 0, 4, 0, .5f, .5f, 0},
                0,
                1,
                5,
                1,
                3,
                5,
                1,
                2,
                3,
                2,
                4,
                3,
                3,
                4,
                5,
                4,
                0,
                5);
        CollapseMesh collapse = new CollapseMesh(mesh);
        int h = finder(collapse).find(5);
        assertThat(collapse.table().vertex(CornerTable.next(h))).isIn(0, 3);
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
    void shouldLeaveAVertexAloneThatJoinsTwoFans() {
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
        assertThat(finder(collapse).find(0)).isEqualTo(CollapseFinder.NONE);
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
        return new CollapseFinder(mesh, scale.positions(), scale.vertexAreas());
    }
}
