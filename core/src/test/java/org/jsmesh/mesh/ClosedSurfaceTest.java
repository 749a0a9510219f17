package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class ClosedSurfaceTest {
    private static final float[] CORNERS = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    private static final int[] TETRAHEDRON = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};

    @Test
    void shouldKnowASolid() {
        assertThat(ClosedSurface.is(mesh(CORNERS, TETRAHEDRON))).isTrue();
    }

    @Test
    void shouldNotTakeForOneWhatHasAHole() {
        assertThat(ClosedSurface.is(mesh(CORNERS, Arrays.copyOf(TETRAHEDRON, 9))))
                .isFalse();
    }

    @Test
    void shouldNotTakeForOneWhatShowsItsInside() {
        int[] inwards = TETRAHEDRON.clone();
        for (int f = 0; f < inwards.length; f += 3) {
            inwards[f] = TETRAHEDRON[f + 1];
            inwards[f + 1] = TETRAHEDRON[f];
        }
        assertThat(ClosedSurface.is(mesh(CORNERS, inwards))).isFalse();
    }

    @Test
    void shouldNotTakeForOneWhatHasAFaceTheWrongWayRound() {
        int[] wrong = TETRAHEDRON.clone();
        wrong[0] = 2;
        wrong[1] = 0;
        assertThat(ClosedSurface.is(mesh(CORNERS, wrong))).isFalse();
    }

    @Test
    void shouldNotTakeForOneAnEdgeOfFourFaces() {
        float[] corners = Arrays.copyOf(CORNERS, 18);
        System.arraycopy(new float[] {0, -1, 0, 0, 0, -1}, 0, corners, 12, 6);
        int[] both = Arrays.copyOf(TETRAHEDRON, 24);
        // Another one on the other side of the edge from 0 to 1.
        System.arraycopy(new int[] {0, 4, 1, 0, 1, 5, 1, 4, 5, 0, 5, 4}, 0, both, 12, 12);
        assertThat(ClosedSurface.is(mesh(corners, both))).isFalse();
    }

    @Test
    void shouldLookAtEachPart() {
        float[] corners = Arrays.copyOf(CORNERS, 24);
        for (int i = 0; i < 12; i++) corners[12 + i] = CORNERS[i] / 4 + 2;
        int[] both = Arrays.copyOf(TETRAHEDRON, 24);
        for (int i = 0; i < 12; i++) both[12 + i] = TETRAHEDRON[i] + 4;
        assertThat(ClosedSurface.is(mesh(corners, both))).isTrue();
        for (int f = 12; f < 24; f += 3) {
            int first = both[f];
            both[f] = both[f + 1];
            both[f + 1] = first;
        }
        assertThat(ClosedSurface.is(mesh(corners, both)))
                .as("the smaller one is inside out")
                .isFalse();
    }

    @Test
    void shouldNotTakeForOneWhatHasNoVolume() {
        assertThat(ClosedSurface.is(mesh(CORNERS, 0, 1, 2, 0, 2, 1))).isFalse();
        assertThat(ClosedSurface.is(mesh(CORNERS, 0, 0, 1))).isFalse();
        assertThat(ClosedSurface.is(new MeshBuilder().build())).isFalse();
    }

    private static Mesh mesh(float[] positions, int... faces) {
        return new MeshBuilder().positions(positions).faceWedges(faces).build();
    }
}
