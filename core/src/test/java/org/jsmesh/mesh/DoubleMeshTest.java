package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;

class DoubleMeshTest {
    private static final double EAST = 450_000;

    /** A mesh far from the origin; float32 would merge its vertices. */
    private static Mesh far(Mesh mesh, double east) {
        double[] positions = new double[mesh.positions().length];
        for (int i = 0; i < positions.length; i++)
            positions[i] = mesh.positions()[i] / 1024.0 + (i % 3 == 0 ? east : i % 3 == 1 ? 12 * east : 0);
        return MeshBuilder.from(mesh).positions(positions).build();
    }

    @Test
    void shouldKeepCoordinatesAsOffsetsFromAnOrigin() {
        Mesh mesh = new MeshBuilder()
                .positions(new double[] {
                    450000.123, 5411000.456, 0, 450000.124, 5411000.456, 0, 450000.123, 5411000.457, .001
                })
                .faceWedges(new int[] {0, 1, 2})
                .build();
        assertThat(mesh.isDouble()).isTrue();
        assertThat(mesh.origin()).containsExactly(450000.124, 5411000.457, 0);
        assertThat(mesh.coordinate(1, 0)).isEqualTo(450000.124);
        assertThat(mesh.positions()[0]).isCloseTo(-.001f, org.assertj.core.data.Offset.offset(1e-9f));
    }

    @Test
    void shouldBeOfFloat32WhereThatHoldsAllCoordinates() {
        Mesh floats = RandomMeshes.FLAT_GRID.mesh(3);
        double[] same = new double[floats.positions().length];
        for (int i = 0; i < same.length; i++) same[i] = floats.positions()[i];
        Mesh mesh = MeshBuilder.from(floats).positions(same).build();
        assertThat(mesh.isDouble()).isFalse();
        assertThat(mesh.positions()).isEqualTo(floats.positions());
    }

    @Test
    void shouldKeepMinusZero() {
        Mesh mesh = new MeshBuilder()
                .positions(new double[] {-0.0, .1, 1, 1, 0, 0, 0, 1, 0})
                .faceWedges(new int[] {0, 1, 2})
                .build();
        assertThat(Double.doubleToRawLongBits(mesh.coordinate(0, 0))).isEqualTo(Long.MIN_VALUE);
    }

    @Test
    void shouldHaveAnIdentityOfEveryBit() {
        Mesh mesh = far(RandomMeshes.FLAT_GRID.mesh(1), EAST + .1);
        String sha = MeshIdentity.sha256(mesh);
        double[] exact = mesh.exactPositions().clone();
        int at = 3 * mesh.vertex(0, 1);
        exact[at] = Math.nextUp(exact[at]);
        Mesh other = MeshBuilder.from(mesh).positions(exact).build();
        assertThat(MeshIdentity.sha256(other)).isNotEqualTo(sha);
        assertThat(MeshComparison.firstDifference(mesh, other).orElseThrow())
                .contains("position x differs in its last bit", "0x411b", "450000.");
        Mesh elsewhere = MeshBuilder.from(mesh)
                .offsets(new double[] {1, 2, 3}, mesh.positions(), mesh.exactPositions())
                .build();
        assertThat(MeshIdentity.sha256(elsewhere)).isEqualTo(sha);
    }

    @Test
    void shouldHaveTheIdentityOfFloat32WhereUsedVerticesAreSuch() {
        Mesh floats = RandomMeshes.FLAT_GRID.mesh(1);
        double[] more = new double[floats.positions().length + 3];
        for (int i = 0; i < floats.positions().length; i++) more[i] = floats.positions()[i];
        more[more.length - 1] = .1;
        Mesh mesh = new MeshBuilder()
                .positions(more)
                .faceWedges(floats.faceWedges())
                .build();
        assertThat(mesh.isDouble()).isTrue();
        assertThat(MeshIdentity.sha256(mesh)).isEqualTo(MeshIdentity.sha256(floats));
        assertThat(MeshComparison.firstDifference(mesh, floats)).isEmpty();
    }

    @Test
    void shouldMergeAndCleanByTheExactCoordinates() {
        double[] apart = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 9, 9, 9};
        for (int i = 0; i < apart.length; i += 3) apart[i] += EAST + .3;
        assertThat(merged(apart).vertices()).isEqualTo(4);
        apart[15] = Math.nextUp(apart[15]); // the third corner of the second face
        assertThat(merged(apart).vertices()).isEqualTo(6);
    }

    private static Mesh merged(double[] positions) {
        Mesh mesh = new MeshBuilder()
                .positions(positions)
                .faceWedges(new int[] {0, 1, 2, 3, 4, 5})
                .build();
        Mesh merged = VertexMerger.merge(MeshCleaner.clean(mesh, new ArrayList<>()), new ArrayList<>());
        assertThat(MeshIdentity.sha256(merged)).isEqualTo(MeshIdentity.sha256(mesh));
        return merged;
    }
}
