package org.jsmesh.encode.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;

class SurfaceProbeTest {
    private static final float[] SQUARE = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0};

    @Test
    void shouldFindItsPointsOnTheOriginal() {
        Mesh mesh = RandomMeshes.TORUS.mesh(3);
        SurfaceProbe.Places places = new SurfaceProbe(mesh, 500).original();
        assertThat(places.size()).isEqualTo(500);
        for (int i = 0; i < 500; i++) {
            assertThat(places.distances()[i]).isCloseTo(0, within(1e-5));
            double sum = 0;
            for (int k = 0; k < 3; k++) {
                assertThat(places.weights()[3 * i + k]).isBetween(0.0, 1.0);
                sum += places.weights()[3 * i + k];
            }
            assertThat(sum).isCloseTo(1, within(1e-9));
        }
    }

    @Test
    void shouldFindTheNearestPointsWithinAFace() {
        SurfaceProbe probe = new SurfaceProbe(mesh(SQUARE, 0, 1, 2, 0, 2, 3), 100);
        // One large triangle a distance of 3 below: every point has its foot within it.
        float[] large = {-10, -10, -3, 30, -10, -3, -10, 30, -3};
        SurfaceProbe.Places there = probe.on(mesh(large, 0, 1, 2));
        SurfaceProbe.Places here = probe.original();
        for (int i = 0; i < 100; i++) {
            assertThat(there.distances()[i]).isCloseTo(3, within(1e-9));
            for (int axis = 0; axis < 2; axis++) {
                double wanted =
                        at(SQUARE, here.faces()[i] == 0 ? new int[] {0, 1, 2} : new int[] {0, 2, 3}, here, i, axis);
                assertThat(at(large, new int[] {0, 1, 2}, there, i, axis)).isCloseTo(wanted, within(1e-5));
            }
        }
    }

    @Test
    void shouldFindTheNearestPointsOnAnEdgeAndAtACorner() {
        // A sliver along the x axis from 0 to 1, below the square that goes to 2.
        float[] sliver = {0, 0, 0, 1, 0, 0, 0, -1, 0};
        SurfaceProbe probe = new SurfaceProbe(mesh(SQUARE, 0, 1, 2, 0, 2, 3), 100);
        SurfaceProbe.Places there = probe.on(mesh(sliver, 0, 1, 2));
        for (int i = 0; i < 100; i++) {
            SurfaceProbe.Places here = probe.original();
            int[] corners = here.faces()[i] == 0 ? new int[] {0, 1, 2} : new int[] {0, 2, 3};
            double x = at(SQUARE, corners, here, i, 0);
            double y = at(SQUARE, corners, here, i, 1);
            assertThat(at(sliver, new int[] {0, 1, 2}, there, i, 0)).isCloseTo(Math.min(x, 1), within(1e-5));
            assertThat(there.distances()[i]).isCloseTo(Math.hypot(Math.max(x - 1, 0), y), within(1e-5));
        }
    }

    @Test
    void shouldTakeFacesWithoutArea() {
        float[] point = {5, 0, 0, 5, 0, 0, 5, 0, 0};
        SurfaceProbe.Places there = new SurfaceProbe(mesh(SQUARE, 0, 1, 2, 0, 2, 3), 10).on(mesh(point, 0, 1, 2));
        for (int i = 0; i < 10; i++) {
            assertThat(there.weights()[3 * i] + there.weights()[3 * i + 1] + there.weights()[3 * i + 2])
                    .isEqualTo(1);
        }
    }

    private static double at(float[] positions, int[] corners, SurfaceProbe.Places places, int i, int axis) {
        double sum = 0;
        for (int k = 0; k < 3; k++) sum += places.weights()[3 * i + k] * positions[3 * corners[k] + axis];
        return sum;
    }

    private static Mesh mesh(float[] positions, int... faces) {
        return new MeshBuilder().positions(positions).faceWedges(faces).build();
    }
}
