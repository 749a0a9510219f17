package org.jsmesh.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MeshComparisonTest {
    private static final float[] POSITIONS = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    private static final int[] SQUARE = {0, 1, 2, 2, 1, 3};

    @Test
    void shouldFindNoDifferenceInTheSameMesh() {
        assertThat(MeshComparison.firstDifference(square(), square())).isEmpty();
    }

    @Test
    void shouldNotCountOrderRotationAndUnreferencedVertices() {
        Mesh shuffled = new MeshBuilder()
                .positions(new float[] {9, 9, 9, 1, 1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0})
                .faceWedges(new int[] {1, 2, 3, 3, 2, 4})
                .build();
        assertThat(MeshComparison.firstDifference(square(), shuffled)).isEmpty();
    }

    @Test
    void shouldNameTheFloatThatDiffersInItsLastBit() {
        float[] changed = POSITIONS.clone();
        changed[9] = Math.nextUp(changed[9]);
        Mesh other = MeshBuilder.from(square()).positions(changed).build();
        assertThat(MeshComparison.firstDifference(square(), other))
                .hasValue(
                        "face 1 of the original (vertices 2 1 3) differs: corner 2 (vertex 3) position x differs in its last bit: "
                                + "0x3f800001 (1.0000001), in the original 0x3f800000 (1.0) (1 of 2 faces missing, 1 extra)");
    }

    @Test
    void shouldTellNegativeFromPositiveZero() {
        float[] changed = POSITIONS.clone();
        changed[2] = -0f;
        Mesh other = MeshBuilder.from(square()).positions(changed).build();
        assertThat(MeshComparison.firstDifference(square(), other).orElseThrow())
                .contains(
                        "face 0",
                        "corner 0 (vertex 0) position z differs: 0x80000000 (-0.0), in the original 0x00000000 (0.0)");
    }

    @Test
    void shouldSeeATurnedFace() {
        Mesh other = MeshBuilder.from(square())
                .faceWedges(new int[] {0, 1, 2, 1, 2, 3})
                .build();
        assertThat(MeshComparison.firstDifference(square(), other).orElseThrow())
                .contains("face 1 of the original", "1 of 2 faces missing, 1 extra");
    }

    @Test
    void shouldCountDuplicateAndDegenerateFaces() {
        Mesh twice = MeshBuilder.from(square())
                .faceWedges(new int[] {0, 1, 2, 0, 1, 2, 2, 1, 3, 3, 3, 1})
                .faceMaterials(null)
                .build();
        Mesh turned = MeshBuilder.from(square())
                .faceWedges(new int[] {2, 1, 3, 1, 3, 3, 2, 0, 1, 1, 2, 0})
                .faceMaterials(null)
                .build();
        assertThat(MeshComparison.firstDifference(twice, turned)).isEmpty();
        assertThat(MeshComparison.firstDifference(twice, square()).orElseThrow())
                .contains("face 0 of the original", "is missing", "2 of 4 faces missing, 0 extra");
        assertThat(MeshComparison.firstDifference(square(), twice).orElseThrow())
                .startsWith("the original has no face")
                .contains("0 of 2 faces missing, 2 extra");
    }

    @Test
    void shouldNameTheAttributeThatDiffers() {
        int[] uv = bits(0, 0, 1, 0, 0, 1, 1, 1);
        int[] changed = uv.clone();
        changed[3] = Float.floatToRawIntBits(Math.nextUp(0f));
        assertThat(MeshComparison.firstDifference(withUv(uv, null), withUv(changed, null))
                        .orElseThrow())
                .contains(
                        "corner 1 (vertex 1) uv v differs in its last bit: 0x00000001 (1.4E-45), in the original 0x00000000 (0.0)");
    }

    @Test
    void shouldTellAnAbsentAttributeFromZero() {
        int[] uv = bits(0, 0, 1, 0, 0, 1, 1, 1);
        BitSet first = new BitSet();
        first.set(0);
        assertThat(MeshComparison.firstDifference(withUv(uv, null), withUv(uv, first))
                        .orElseThrow())
                .contains("corner 0 (vertex 0) has no uv, in the original one");
        assertThat(MeshComparison.firstDifference(square(), withUv(uv, null)).orElseThrow())
                .contains("has a uv, in the original none");
    }

    @Test
    void shouldNotCountAChannelThatNoCornerHas() {
        BitSet all = new BitSet();
        all.set(0, 4);
        assertThat(MeshComparison.firstDifference(square(), withUv(new int[8], all)))
                .isEmpty();
    }

    @Test
    void shouldTellChannelsApartByKindAndOrderNotByName() {
        int[] one = bits(0, 0, 1, 0, 0, 1, 1, 1);
        int[] two = bits(5, 5, 6, 5, 5, 6, 6, 6);
        Mesh a = withUvs(uv("uv", one), uv("uv2", two));
        assertThat(MeshComparison.firstDifference(a, withUvs(uv("st", one), uv("pq", two))))
                .isEmpty();
        assertThat(MeshComparison.firstDifference(a, withUvs(uv("uv2", two), uv("uv", one))))
                .isPresent();
        assertThat(MeshComparison.firstDifference(a, withUvs(uv("uv", one))).orElseThrow())
                .contains("has no uv2, in the original one");
        assertThat(MeshComparison.firstDifference(withUvs(uv("uv", one)), a).orElseThrow())
                .contains("has a uv2, in the original none");
    }

    @Test
    void shouldCompareMaterialsByContentNotById() {
        Material red = Material.named("red");
        Material blue = Material.named("blue");
        Mesh a = MeshBuilder.from(square())
                .materials(List.of(red, blue))
                .faceMaterials(new int[] {0, 1})
                .build();
        Mesh b = MeshBuilder.from(square())
                .materials(List.of(blue, red))
                .faceMaterials(new int[] {1, 0})
                .build();
        Mesh c = MeshBuilder.from(square())
                .materials(List.of(red))
                .faceMaterials(new int[] {0, -1})
                .build();
        assertThat(MeshComparison.firstDifference(a, b)).isEmpty();
        assertThat(MeshComparison.firstDifference(a, c).orElseThrow())
                .contains("face 1 of the original", "material is none, in the original \"blue\"");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Kd 1 0 0 map_Kd a.png | Kd 1 0 0.5 map_Kd a.png | Kd is 1.0 0.0 0.5, in the original 1.0 0.0 0.0",
                "Kd 1 0 0 | Kd 1 0 -0 | Kd is 1.0 0.0 -0.0, in the original 1.0 0.0 0.0",
                "Kd 1 Ks 1 | Kd 1 | lacks Ks 1.0 of the original",
                "Kd 1 | Kd 1 Ns 4 | has Ns 4.0, in the original nothing there",
                "Kd 1 Ks 2 | Ks 2 Kd 1 | has Ks 2.0, in the original there is Kd 1.0",
                "map_Kd a.png | map_Kd b.png | map_Kd is \"b.png\", in the original \"a.png\"",
                "Kd NaN:7fc00000 | Kd NaN:7fc00001 | Kd is 0x7fc00001, in the original 0x7fc00000"
            })
    void shouldNameTheKeyOfAMaterialThatDiffersWithBothValues(String original, String other, String difference) {
        assertThat(MeshComparison.firstDifference(painted(original), painted(other))
                        .orElseThrow())
                .contains("material \"paint\": " + difference)
                .doesNotContain("@");
    }

    /** A square of one material: keys with numbers, {@code map_} keys with a path, a NaN with its bits. */
    private static Mesh painted(String definition) {
        List<Material.Parameter> parameters = new ArrayList<>();
        List<Material.TextureReference> textures = new ArrayList<>();
        for (String part : definition.split(" (?=[A-Za-z]+_?[A-Za-z]* )")) {
            String[] words = part.split(" ");
            if (words[0].startsWith("map_")) {
                textures.add(new Material.TextureReference(words[0], words[1]));
                continue;
            }
            float[] values = new float[words.length - 1];
            for (int i = 0; i < values.length; i++)
                values[i] = words[i + 1].startsWith("NaN:")
                        ? Float.intBitsToFloat(Integer.parseUnsignedInt(words[i + 1].substring(4), 16))
                        : Float.parseFloat(words[i + 1]);
            parameters.add(new Material.Parameter(words[0], values));
        }
        return MeshBuilder.from(square())
                .materials(List.of(new Material("paint", parameters, textures)))
                .faceMaterials(new int[] {0, 0})
                .build();
    }

    private static Mesh square() {
        return new MeshBuilder()
                .positions(POSITIONS.clone())
                .faceWedges(SQUARE.clone())
                .build();
    }

    private static Mesh withUv(int[] values, BitSet absent) {
        return MeshBuilder.from(square())
                .channels(
                        List.of(new Channel(Channel.Semantic.TEXCOORD, "uv", 2, Channel.Type.FLOAT32, values, absent)))
                .build();
    }

    private static Mesh withUvs(Channel... channels) {
        return MeshBuilder.from(square()).channels(List.of(channels)).build();
    }

    private static Channel uv(String name, int[] values) {
        return new Channel(Channel.Semantic.TEXCOORD, name, 2, Channel.Type.FLOAT32, values, null);
    }

    private static int[] bits(float... values) {
        int[] bits = new int[values.length];
        for (int i = 0; i < bits.length; i++) bits[i] = Float.floatToRawIntBits(values[i]);
        return bits;
    }
}
