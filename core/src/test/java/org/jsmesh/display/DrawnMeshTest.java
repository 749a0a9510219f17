package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.junit.jupiter.api.Test;

class DrawnMeshTest {
    private static final double RIGHT_ANGLE_IS_SHARP = Math.cos(Math.toRadians(60));
    private static final double RIGHT_ANGLE_IS_SMOOTH = Math.cos(Math.toRadians(100));

    /** Two triangles that share the edge 0–1 at a right angle: one in the plane z = 0, one in y = 0. */
    private static MeshBuilder fold() {
        return new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})
                .faceWedges(new int[] {0, 1, 2, 1, 0, 3});
    }

    @Test
    void shouldGiveEverySideOfACreaseItsOwnNormal() {
        DrawnArrays arrays = draw(fold().build(), RIGHT_ANGLE_IS_SHARP);
        assertThat(arrays.vertices()).isEqualTo(6);
        assertThat(arrays.indices()).containsExactly(0, 1, 2, 4, 5, 3);
        assertThat(normal(arrays, 0)).containsExactly(0, 0, 1);
        assertThat(normal(arrays, 5)).containsExactly(0, 1, 0);
        assertThat(position(arrays, 4)).containsExactly(1, 0, 0);
        assertThat(position(arrays, 5)).containsExactly(0, 0, 0);
    }

    @Test
    void shouldShadeSmoothlyBelowTheCreaseAngle() {
        DrawnArrays arrays = draw(fold().build(), RIGHT_ANGLE_IS_SMOOTH);
        assertThat(arrays.vertices()).isEqualTo(4);
        assertThat(arrays.indices()).containsExactly(0, 1, 2, 1, 0, 3);
        float half = (float) Math.sqrt(.5);
        assertThat(normal(arrays, 0)).containsExactly(new float[] {0, half, half}, within(1e-6f));
        assertThat(normal(arrays, 2)).containsExactly(0, 0, 1);
    }

    @Test
    void shouldSmoothAcrossASeamOfTextureCoordinates() {
        Channel uv = new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, new int[12], null);
        Mesh mesh = fold().wedgeVertices(new int[] {0, 1, 2, 1, 0, 3})
                .faceWedges(new int[] {0, 1, 2, 3, 4, 5})
                .channels(List.of(uv))
                .build();
        DrawnArrays arrays = draw(mesh, RIGHT_ANGLE_IS_SMOOTH);
        assertThat(arrays.vertices()).isEqualTo(6);
        assertThat(normal(arrays, 0)).isEqualTo(normal(arrays, 4));
        assertThat(arrays.textureCoordinates()).hasSize(12);
    }

    @Test
    void shouldKeepTheNormalsOfTheFileAndComputeTheMissingOnes() {
        int[] values = new int[12];
        for (int w = 0; w < 4; w++) values[3 * w] = Float.floatToRawIntBits(1);
        BitSet absent = new BitSet();
        absent.set(3);
        Channel given = new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, values, absent);
        DrawnArrays arrays = draw(fold().channels(List.of(given)).build(), RIGHT_ANGLE_IS_SHARP);
        assertThat(arrays.vertices()).isEqualTo(4);
        assertThat(normal(arrays, 0)).containsExactly(1, 0, 0);
        assertThat(normal(arrays, 3)).containsExactly(0, 1, 0);
    }

    @Test
    void shouldNotFailOnFacesWithoutArea() {
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 2, 0, 0})
                .faceWedges(new int[] {0, 1, 2, 1, 1, 1})
                .build();
        DrawnArrays arrays = draw(mesh, RIGHT_ANGLE_IS_SHARP);
        for (float value : arrays.normals()) assertThat(value).isFinite();
        assertThat(arrays.indices()).hasSize(6);
    }

    @Test
    void shouldSortFacesByLook() {
        Material red = new Material("red", List.of(new Material.Parameter("Kd", 1, 0, 0)), List.of());
        Material alsoRed = new Material("also red", List.of(new Material.Parameter("Kd", 1, 0, 0)), List.of());
        Mesh mesh = new MeshBuilder()
                .positions(new float[9])
                .faceWedges(new int[] {0, 1, 2, 1, 2, 0, 2, 0, 1, 0, 2, 1})
                .faceMaterials(new int[] {1, -1, 0, -1})
                .materials(List.of(red, alsoRed))
                .build();
        DrawnArrays arrays = draw(mesh, RIGHT_ANGLE_IS_SHARP);
        assertThat(arrays.groups()).containsExactly(0, 0, 6, 1, 6, 6);
        assertThat(arrays.indices()).containsExactly(1, 2, 0, 0, 2, 1, 0, 1, 2, 2, 0, 1);
    }

    @Test
    void shouldPackColours() {
        Channel colour = new Channel(
                Channel.Semantic.COLOUR,
                "colour",
                3,
                Channel.Type.UINT8,
                new int[] {255, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                null);
        DrawnArrays arrays = draw(fold().channels(List.of(colour)).build(), RIGHT_ANGLE_IS_SMOOTH);
        assertThat(arrays.colours()[0]).isEqualTo(0xff0100ff);
        assertThat(arrays.colours()[1]).isEqualTo(0xff000000);
    }

    private static DrawnArrays draw(Mesh mesh, double creaseCosine) {
        return new DrawnMesh(mesh, DisplaySlots.of(mesh.materials()), creaseCosine).arrays();
    }

    private static float[] normal(DrawnArrays arrays, int vertex) {
        return java.util.Arrays.copyOfRange(arrays.normals(), 3 * vertex, 3 * vertex + 3);
    }

    private static float[] position(DrawnArrays arrays, int vertex) {
        return java.util.Arrays.copyOfRange(arrays.positions(), 3 * vertex, 3 * vertex + 3);
    }
}
