package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.junit.jupiter.api.Test;

/** Groups of faces take the place of the crease angle where corners have no normals. */
class SmoothingGroupsTest {
    private static final double[] CREASES = {Math.cos(Math.toRadians(60)), Math.cos(Math.toRadians(100))};
    private static final float HALF = (float) Math.sqrt(.5);
    private static final float[] UP = {0, 0, 1};
    private static final float[] FRONT = {0, 1, 0};
    private static final float[] BETWEEN = {0, HALF, HALF};

    /** Two triangles that share the edge 0–1 at a right angle: one in the plane z = 0, one in y = 0. */
    private static MeshBuilder fold(int... groups) {
        return new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})
                .faceWedges(new int[] {0, 1, 2, 1, 0, 3})
                .faceChannels(List.of(smoothing(groups)));
    }

    private static FaceChannel smoothing(int... groups) {
        return new FaceChannel(FaceChannel.SMOOTHING, 1, Channel.Type.INT32, groups, List.of());
    }

    private static float[] normal(RenderMesh drawn, int corner) {
        int at = 3 * drawn.indices()[corner];
        return Arrays.copyOfRange(drawn.normals(), at, at + 3);
    }

    private static void shouldShade(Mesh mesh, float[] first, float[] second) {
        for (double crease : CREASES) {
            RenderMesh drawn = RenderMesh.of(mesh, crease);
            for (int corner = 0; corner < 2; corner++) {
                assertThat(normal(drawn, corner)).containsExactly(first, within(1e-6f));
                assertThat(normal(drawn, 3 + corner)).containsExactly(second, within(1e-6f));
            }
        }
    }

    @Test
    void shouldSmoothWithinAGroupAndNowhereElse() {
        shouldShade(fold(3, 3).build(), BETWEEN, BETWEEN);
        shouldShade(fold(1, 2).build(), UP, FRONT);
        shouldShade(fold(1, 3).build(), UP, FRONT);
        shouldShade(fold(0, 0).build(), UP, FRONT);
        shouldShade(fold(0, 3).build(), UP, FRONT);
        shouldShade(fold(-1, -1).build(), BETWEEN, BETWEEN);
    }

    @Test
    void shouldSmoothAGroupWhoseFacesAreApartInTheOrderAroundAVertex() {
        int[] faces = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 1, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0})
                .faceWedges(faces)
                .faceChannels(List.of(smoothing(1, 2, 1, 0)))
                .build();
        RenderMesh drawn = RenderMesh.of(mesh, CREASES[0]);
        float third = (float) Math.sqrt(1 / 3.0);
        assertThat(normal(drawn, 0)).containsExactly(UP, within(1e-6f));
        assertThat(normal(drawn, 6)).containsExactly(UP, within(1e-6f));
        assertThat(normal(drawn, 3)).containsExactly(new float[] {-third, third, third}, within(1e-6f));
        assertThat(normal(drawn, 9)).containsExactly(new float[] {third, -third, third}, within(1e-6f));
    }

    @Test
    void shouldPreferTheNormalsOfTheFile() {
        int one = Float.floatToIntBits(1);
        Channel given = new Channel(
                Channel.Semantic.NORMAL,
                "normal",
                3,
                Channel.Type.FLOAT32,
                new int[] {one, 0, 0, one, 0, 0, one, 0, 0, one, 0, 0},
                null);
        float[] right = {1, 0, 0};
        shouldShade(fold(0, 0).channels(List.of(given)).build(), right, right);
    }

    @Test
    void shouldComputeANormalWhereTheFileHasOneWithoutLength() {
        Channel given = new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, new int[12], null);
        shouldShade(fold(3, 3).channels(List.of(given)).build(), BETWEEN, BETWEEN);
    }
}
