package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.jsmesh.encode.measure.DistanceMeter;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.UpAxis;
import org.junit.jupiter.api.Test;

class ErrorMapTest {
    /** A square at z = 0; with a pyramid on it that all its corners lie on. */
    private static Mesh square(boolean hasTop) {
        float[] positions = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 1, 1};
        int[] flat = {0, 1, 2, 0, 2, 3};
        int[] steep = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(hasTop ? steep : flat)
                .build();
    }

    @Test
    void shouldFindWhatLiesFarFromTheInsideOfAFace() {
        Mesh shown = square(false);
        Framing framing = Framing.of(new float[] {0, 0, 0, 2, 2, 1}, UpAxis.UNKNOWN);
        ErrorMap map = ErrorMap.of(shown, new DistanceMeter(square(true)), framing, () -> false);
        int cuts = ErrorMap.cuts(2);
        assertThat(map.distances()).hasSize(2 * 3 * cuts * cuts);
        assertThat(map.positions()).hasSize(3 * map.distances().length);
        // The point below the top is nearest to one of its sides, which rise by 45°.
        assertThat(map.farthest()).isCloseTo(Math.sqrt(.5), within(1e-6));
        assertThat(map.distances()[0]).isZero();
    }

    @Test
    void shouldCutAFaceIntoItsWholeArea() {
        Mesh shown = square(false);
        Framing framing = Framing.of(new float[] {-1, -1, -1, 1, 1, 1}, UpAxis.UNKNOWN);
        float[] p = ErrorMap.of(shown, new DistanceMeter(shown), framing, () -> false)
                .positions();
        double area = 0;
        for (int i = 0; i < p.length; i += 9)
            area += ((p[i + 3] - p[i]) * (p[i + 7] - p[i + 1]) - (p[i + 6] - p[i]) * (p[i + 4] - p[i + 1])) / 2.;
        assertThat(area * framing.radius() * framing.radius()).isCloseTo(4, within(1e-4));
    }

    @Test
    void shouldMeasureTheMiddleOfFacesOfALargeMesh() {
        Mesh torus = Shapes.torus(300, 300);
        assertThat(ErrorMap.cuts(torus.faces())).isEqualTo(1);
        Framing framing = Framing.of(torus.bounds(), UpAxis.UNKNOWN);
        ErrorMap map = ErrorMap.of(torus, new DistanceMeter(square(true)), framing, () -> false);
        assertThat(map.distances()).hasSize(3 * torus.faces());
        assertThat(map.distances()[0]).isPositive().isEqualTo(map.distances()[2]);
    }

    @Test
    void shouldStopWhenNobodyWantsIt() {
        Framing framing = Framing.of(new float[] {0, 0, 0, 2, 2, 1}, UpAxis.UNKNOWN);
        assertThat(ErrorMap.of(square(false), new DistanceMeter(square(true)), framing, () -> true))
                .isNull();
    }
}
