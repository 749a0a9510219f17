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

class RenderMeshTest {
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
        RenderMesh arrays = draw(fold().build(), RIGHT_ANGLE_IS_SHARP);
        assertThat(arrays.vertices()).isEqualTo(6);
        assertThat(arrays.indices()).containsExactly(0, 1, 2, 4, 5, 3);
        assertThat(normal(arrays, 0)).containsExactly(0, 0, 1);
        assertThat(normal(arrays, 5)).containsExactly(0, 1, 0);
        assertThat(position(arrays, 4)).containsExactly(1, 0, 0);
        assertThat(position(arrays, 5)).containsExactly(0, 0, 0);
    }

    @Test
    void shouldShadeSmoothlyBelowTheCreaseAngle() {
        RenderMesh arrays = draw(fold().build(), RIGHT_ANGLE_IS_SMOOTH);
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
        RenderMesh arrays = draw(mesh, RIGHT_ANGLE_IS_SMOOTH);
        assertThat(arrays.vertices()).isEqualTo(6);
        assertThat(normal(arrays, 0)).isEqualTo(normal(arrays, 4));
        assertThat(arrays.textureCoordinates()[0]).hasSize(12);
    }

    @Test
    void shouldKeepTheNormalsOfTheFileAndComputeTheMissingOnes() {
        int[] values = new int[12];
        for (int w = 0; w < 4; w++) values[3 * w] = Float.floatToRawIntBits(1);
        BitSet absent = new BitSet();
        absent.set(3);
        Channel given = new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.FLOAT32, values, absent);
        RenderMesh arrays = draw(fold().channels(List.of(given)).build(), RIGHT_ANGLE_IS_SHARP);
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
        RenderMesh arrays = draw(mesh, RIGHT_ANGLE_IS_SHARP);
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
        RenderMesh arrays = draw(mesh, RIGHT_ANGLE_IS_SHARP);
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
        RenderMesh arrays = draw(fold().channels(List.of(colour)).build(), RIGHT_ANGLE_IS_SMOOTH);
        assertThat(arrays.colours()[0]).isEqualTo(0xff0100ff);
        assertThat(arrays.colours()[1]).isEqualTo(0xff000000);
    }

    @Test
    void shouldDrawACubeWithHardEdges() {
        RenderMesh drawn = draw(DisplayShapes.cube(), CreaseAngle.cosine(12, 12, 12));
        assertThat(drawn.vertices()).isEqualTo(24);
        for (int f = 0; f < 12; f++) {
            float[] expected = new float[3];
            expected[f / 4] = f / 2 % 2 == 0 ? -1 : 1;
            for (int k = 0; k < 3; k++)
                assertThat(normal(drawn, drawn.indices()[3 * f + k])).containsExactly(expected, within(0f));
        }
    }

    @Test
    void shouldDrawASphereSmoothly() {
        Mesh sphere = DisplayShapes.sphere(24, 48);
        RenderMesh drawn = draw(sphere, CreaseAngle.cosine(sphere.faces(), sphere.faces(), sphere.faces()));
        assertThat(drawn.vertices()).isEqualTo(sphere.vertices());
        assertThat(drawn.indices()).isEqualTo(sphere.faceWedges());
        for (int v = 0; v < drawn.vertices(); v++) {
            double cosine = 0;
            for (int k = 0; k < 3; k++) cosine += normal(drawn, v)[k] * position(drawn, v)[k];
            assertThat(cosine).isGreaterThan(Math.cos(Math.toRadians(2)));
        }
    }

    @Test
    void shouldAverageAllFacesAroundAVertexOfVeryMany() {
        // A cone of 100 faces whose opposite faces are far from smooth.
        Mesh cone = DisplayShapes.cone(100);
        RenderMesh drawn = draw(cone, CreaseAngle.cosine(100, 100, 100));
        assertThat(drawn.vertices()).isEqualTo(101);
        assertThat(normal(drawn, 0)).containsExactly(new float[] {0, 0, 1}, within(1e-6f));
    }

    @Test
    void shouldWeightFacesByArea() {
        Mesh mesh = new MeshBuilder()
                .positions(new float[] {0, 0, 0, 0, 2, 0, -3, 0, 0, 0, 0, -1})
                .faceWedges(new int[] {0, 1, 2, 0, 3, 1})
                .build();
        float length = (float) Math.sqrt(10);
        RenderMesh drawn = draw(mesh, RIGHT_ANGLE_IS_SMOOTH);
        assertThat(normal(drawn, 0)).containsExactly(new float[] {1 / length, 0, 3 / length}, within(1e-6f));
    }

    @Test
    void shouldNotMergeWedgesWithDifferentTextureCoordinates() {
        int[] uv = new int[12];
        for (int i = 0; i < uv.length; i++) uv[i] = Float.floatToRawIntBits(i);
        Mesh mesh = fold().wedgeVertices(new int[] {0, 1, 2, 1, 0, 3})
                .faceWedges(new int[] {0, 1, 2, 3, 4, 5})
                .channels(List.of(new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, uv, null)))
                .build();
        RenderMesh drawn = draw(mesh, RIGHT_ANGLE_IS_SMOOTH);
        assertThat(position(drawn, 0)).isEqualTo(position(drawn, 4));
        assertThat(drawn.indices()).containsExactly(0, 1, 2, 3, 4, 5);
        assertThat(drawn.textureCoordinates()[0]).containsExactly(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11);
    }

    @Test
    void shouldNumberSetsOfTextureCoordinatesAsGltfDoes() {
        Channel second =
                new Channel(Channel.Semantic.TEXCOORD, "TEXCOORD_1", 2, Channel.Type.FLOAT32, new int[8], null);
        Channel beyond =
                new Channel(Channel.Semantic.TEXCOORD, "TEXCOORD_7", 2, Channel.Type.FLOAT32, new int[8], null);
        RenderMesh drawn = draw(fold().channels(List.of(second, beyond)).build(), RIGHT_ANGLE_IS_SMOOTH);
        assertThat(drawn.textureCoordinates()).hasNumberOfRows(4);
        assertThat(drawn.textureCoordinates()[1]).hasSize(2 * drawn.vertices());
        assertThat(drawn.hasTextureCoordinates()).isTrue();
        assertThat(draw(fold().build(), RIGHT_ANGLE_IS_SMOOTH).hasTextureCoordinates())
                .isFalse();
    }

    @Test
    void shouldHandOutTangentsAndZerosWhereAWedgeHasNone() {
        int[] values = new int[16];
        for (int i = 0; i < values.length; i++) values[i] = Float.floatToRawIntBits(i);
        BitSet absent = new BitSet();
        absent.set(2);
        Channel tangents = new Channel(Channel.Semantic.CUSTOM, "TANGENT", 4, Channel.Type.FLOAT32, values, absent);
        float[] drawn = draw(fold().channels(List.of(tangents)).build(), RIGHT_ANGLE_IS_SMOOTH)
                .tangents();
        assertThat(drawn).containsExactly(0, 1, 2, 3, 4, 5, 6, 7, 0, 0, 0, 0, 12, 13, 14, 15);
    }

    @Test
    void shouldTurnLinearColoursIntoThoseOfAScreen() {
        int[] values = {0, 32768, 65535, 65535, 0, 0, 0, 0, 0, 0, 0, 0};
        for (String name : new String[] {"COLOR_0", "colour"}) {
            Channel colours = new Channel(Channel.Semantic.COLOUR, name, 3, Channel.Type.UINT16, values, null);
            int first = draw(fold().channels(List.of(colours)).build(), RIGHT_ANGLE_IS_SMOOTH)
                    .colours()[0];
            assertThat(first).isEqualTo(name.equals("colour") ? 0xffff8000 : 0xffffbc00);
        }
    }

    @Test
    void shouldTakeNormalsInBytesFromMinusOneToOne() {
        int[] bytes = {0, 255, 0, 255, 0, 255, 0, 0, 0, 255, 255, 255};
        BitSet absent = new BitSet();
        absent.set(2);
        Channel whole = new Channel(Channel.Semantic.NORMAL, "normal", 3, Channel.Type.UINT8, bytes, null);
        Channel partial = whole.withValues(bytes, absent);
        for (Channel given : List.of(whole, partial)) {
            RenderMesh drawn = draw(fold().channels(List.of(given)).build(), RIGHT_ANGLE_IS_SHARP);
            assertThat(normal(drawn, 0)).containsExactly(-1, 1, -1);
            assertThat(normal(drawn, 1)).containsExactly(1, -1, 1);
        }
    }

    @Test
    void shouldNumberItsArrays() {
        Mesh mesh = DisplayShapes.coloured(DisplayShapes.cube());
        RenderMesh drawn = draw(mesh, RIGHT_ANGLE_IS_SHARP);
        Object[] whole = {
            drawn.positions(),
            drawn.normals(),
            drawn.colours(),
            drawn.indices(),
            drawn.groups(),
            drawn.tangents(),
            drawn.textureCoordinates()[0],
            drawn.textureCoordinates()[1],
            drawn.textureCoordinates()[2],
            drawn.textureCoordinates()[3]
        };
        for (int array = 0; array < whole.length; array++)
            assertThat(numbered(drawn, array, whole[array] instanceof float[])).isEqualTo(whole[array]);
    }

    private static Object numbered(RenderMesh drawn, int array, boolean floats) {
        float[] numbers = new float[drawn.count(array)];
        int[] integers = new int[drawn.count(array)];
        for (int i = 0; i < integers.length; i++) {
            integers[i] = drawn.bits(array, i);
            numbers[i] = Float.intBitsToFloat(integers[i]);
        }
        return floats ? numbers : integers;
    }

    @Test
    void shouldSayWhereEachFaceLies() {
        Material red = new Material("red", List.of(new Material.Parameter("Kd", 1, 0, 0)), List.of());
        Mesh mesh = MeshBuilder.from(DisplayShapes.cube())
                .materials(List.of(red))
                .faceMaterials(new int[] {0, -1, 0, -1, 0, -1, 0, -1, 0, -1, 0, -1})
                .build();
        RenderMesh drawn = draw(mesh, RIGHT_ANGLE_IS_SMOOTH);
        int[] first = drawn.firstIndices(mesh);
        for (int c = 0; c < 36; c++)
            assertThat(drawn.indices()[first[c / 3] + c % 3]).isEqualTo(mesh.faceWedges()[c]);
    }

    @Test
    void shouldShowOneComponentAsGreyAndAbsentColoursAsWhite() {
        BitSet absent = new BitSet();
        absent.set(1);
        Channel grey = new Channel(
                Channel.Semantic.COLOUR, "colour", 1, Channel.Type.UINT8, new int[] {128, 0, 0, 255}, absent);
        RenderMesh drawn = draw(fold().channels(List.of(grey)).build(), RIGHT_ANGLE_IS_SMOOTH);
        assertThat(drawn.colours()).containsExactly(0xff808080, -1, 0xff000000, -1);
    }

    private static RenderMesh draw(Mesh mesh, double creaseCosine) {
        return RenderMesh.of(mesh, creaseCosine);
    }

    private static float[] normal(RenderMesh arrays, int vertex) {
        return java.util.Arrays.copyOfRange(arrays.normals(), 3 * vertex, 3 * vertex + 3);
    }

    private static float[] position(RenderMesh arrays, int vertex) {
        return java.util.Arrays.copyOfRange(arrays.positions(), 3 * vertex, 3 * vertex + 3);
    }
}
