package org.jsmesh.encode;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.Texture;
import org.junit.jupiter.api.Test;

/** The limits of {@code docs/format.md}: what is within them is encoded, what is beyond is refused with a remedy. */
class MeshEncoderLimitsTest {
    @Test
    void shouldHoldAsManyImagesAsDocumentedAndNoMore() {
        assertThat(encode(withImages(4096)).header().images()).hasSize(4096);
        assertRefused(withImages(4097), "4097 images", "4096", "Join images");
        List<Texture> names = new ArrayList<>();
        for (int i = 0; i < 4096; i++) names.add(new Texture(i + ".png", new byte[] {1}));
        assertThat(encode(builder().textures(names).build()).header().images())
                .singleElement()
                .satisfies(image -> assertThat(image.paths()).hasSize(4096));
    }

    @Test
    void shouldHoldANameOfTheDocumentedLengthAndNoLongerOne() {
        String longest = "é".repeat(2048);
        assertThat(encode(with(Material.named(longest)))
                        .header()
                        .materials()
                        .get(0)
                        .name())
                .isEqualTo(longest);
        assertRefused(with(Material.named(longest + "x")), "4097 bytes", "4096", "shorter name");
        assertRefused(
                with(new Material("m", List.of(), List.of(new Material.TextureReference("map_Kd", "y".repeat(5000))))),
                "5000 bytes",
                "\"yyy");
    }

    @Test
    void shouldHoldAsManyParametersAndValuesAsDocumentedAndNoMore() {
        Material.Parameter one = new Material.Parameter("Kd", 1);
        Material most = new Material("most", Collections.nCopies(4096, one), List.of());
        assertThat(encode(with(most)).header().materials()).containsExactly(most);
        assertRefused(
                with(new Material("rich", Collections.nCopies(4097, one), List.of())), "4097 parameters", "\"rich\"");
        Material wide = new Material("wide", List.of(new Material.Parameter("Kd", new float[256])), List.of());
        assertThat(encode(with(wide)).header().materials()).containsExactly(wide);
        Material wider = new Material("wide", List.of(new Material.Parameter("Kd", new float[257])), List.of());
        assertRefused(with(wider), "257 values of \"Kd\"", "256");
    }

    @Test
    void shouldRefuseTextsThatAreTooLongTogether() {
        String definition = "{\"extras\":\"" + "x".repeat((1 << 20) - 13) + "\"}";
        List<Material> materials = new ArrayList<>();
        int[] corners = new int[3 * 16];
        int[] faces = new int[16];
        for (int i = 0; i < 16; i++) {
            materials.add(new Material("m" + i, List.of(), List.of(), definition));
            for (int k = 0; k < 3; k++) corners[3 * i + k] = k + i % 2;
            faces[i] = i;
        }
        assertRefused(
                builder()
                        .faceWedges(corners)
                        .materials(materials)
                        .faceMaterials(faces)
                        .build(),
                "definitions of materials have ",
                "together",
                "16711680",
                "Leave the extras");
    }

    @Test
    void shouldRefuseNumbersThatAreNotFinite() {
        for (float value : new float[] {Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NaN})
            assertRefused(
                    with(new Material("m", List.of(new Material.Parameter("Kd", 1, value)), List.of())),
                    "\"Kd\" of the material \"m\" is " + value,
                    "finite");
    }

    private static void assertRefused(Mesh mesh, String... words) {
        assertThatThrownBy(() -> encode(mesh))
                .isInstanceOf(IllegalArgumentException.class)
                .message()
                .contains(words);
    }

    private static EncodedArchive encode(Mesh mesh) {
        return new MeshEncoder(EncoderSettings.defaults()).encode(mesh, ProgressListener.NONE);
    }

    private static Mesh with(Material material) {
        return builder()
                .materials(List.of(material))
                .faceMaterials(new int[] {0, 0})
                .build();
    }

    private static Mesh withImages(int count) {
        List<Texture> images = new ArrayList<>();
        for (int i = 0; i < count; i++) images.add(new Texture(i + ".png", new byte[] {(byte) i, (byte) (i >> 8)}));
        return builder().textures(images).build();
    }

    private static MeshBuilder builder() {
        return new MeshBuilder()
                .positions(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})
                .faceWedges(new int[] {0, 1, 2, 2, 1, 3});
    }
}
