package org.jsmesh.encode.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;

class DistanceMeterTest {
    private static final float[] SQUARE = {0, 0, 0, 3, 0, 0, 3, 4, 0, 0, 4, 0}; // diagonal 5
    private static final int[] HALVES = {0, 1, 2, 0, 2, 3};

    @Test
    void shouldFindNoDistanceFromTheOriginal() {
        Mesh mesh = RandomMeshes.SPHERE.mesh(1);
        DistanceMeter.Distance d = measure(mesh, mesh.positions(), mesh.faceWedges());
        assertThat(d.mean()).isCloseTo(0, within(1e-6));
        assertThat(d.maximum()).isCloseTo(0, within(1e-4));
    }

    @Test
    void shouldMeasureInPercentOfTheDiagonal() {
        float[] raised = SQUARE.clone();
        for (int i = 2; i < 12; i += 3) raised[i] = 0.1f;
        DistanceMeter.Distance d = measure(square(), raised, HALVES);
        assertThat(d.mean()).isCloseTo(2, within(1e-4));
        assertThat(d.maximum()).isCloseTo(2, within(1e-4));
    }

    @Test
    void shouldAverageBothDirections() {
        // half of the square is missing: the LOD lies on the original, the original is on average a third of the height
        // (12/5) of its missing half away
        DistanceMeter.Distance d = measure(square(), SQUARE, new int[] {0, 1, 2});
        assertThat(d.mean()).isCloseTo(0.5 * 0.5 * (12 / 5.0 / 3) / 5 * 100, within(0.02));
        assertThat(d.maximum()).isCloseTo(12 / 5.0 / 5 * 100, within(1e-4)); // at the missing vertex, on no sample
    }

    @Test
    void shouldFindASpikeOfTheOriginal() {
        float[] positions = {0, 0, 0, 3, 0, 0, 3, 4, 0, 0, 4, 0, 1, 1, 2};
        Mesh spiked = new MeshBuilder()
                .positions(positions)
                .faceWedges(new int[] {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4})
                .build();
        assertThat(measure(spiked, positions, HALVES).maximum()).isCloseTo(2 / Math.sqrt(29) * 100, within(1e-4));
    }

    @Test
    void shouldIgnoreVerticesThatNoFaceUses() {
        float[] more = {0, 0, 0, 3, 0, 0, 3, 4, 0, 0, 4, 0, 99, 99, 99};
        Mesh mesh = new MeshBuilder().positions(more).faceWedges(HALVES).build();
        float[] raised = SQUARE.clone();
        for (int i = 2; i < 12; i += 3) raised[i] = 0.1f;
        assertThat(measure(mesh, raised, HALVES).mean()).isCloseTo(2, within(1e-4));
    }

    @Test
    void shouldGiveTheSameTwice() {
        Mesh mesh = RandomMeshes.TORUS.mesh(2);
        float[] moved = mesh.positions().clone();
        for (int i = 0; i < moved.length; i += 7) moved[i] += 0.05f;
        assertThat(measure(mesh, moved, mesh.faceWedges())).isEqualTo(measure(mesh, moved, mesh.faceWedges()));
    }

    @Test
    void shouldRefuseAnOriginalWithoutFaces() {
        Mesh empty = new MeshBuilder().positions(SQUARE).build();
        assertThatThrownBy(() -> new DistanceMeter(empty)).isInstanceOf(IllegalArgumentException.class);
    }

    private static Mesh square() {
        return new MeshBuilder().positions(SQUARE).faceWedges(HALVES).build();
    }

    private static DistanceMeter.Distance measure(Mesh original, float[] positions, int[] triangles) {
        return new DistanceMeter(original).measure(positions, triangles, triangles.length / 3);
    }
}
