package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Material.TextureReference;
import org.junit.jupiter.api.Test;

class GltfLookTest {
    @Test
    void shouldHaveTheValuesOfTheSpecificationWhereTheFileSaysNothing() {
        DisplayMaterial look = look("{}");
        assertThat(look.colour()).containsExactly(1f, 1f, 1f, 1f);
        assertThat(look.metallic()).isEqualTo(1);
        assertThat(look.roughness()).isEqualTo(1);
        assertReflects(look, .04f, .04f, .04f, 1);
        assertThat(look.emission()).isNull();
        assertThat(look.coat()).isNull();
        assertThat(look.alpha()).isEqualTo(DisplayMaterial.Alpha.OPAQUE);
        assertThat(look.cutoff()).isEqualTo(.5f);
        assertThat(look.doubleSided()).isFalse();
        assertThat(look.unlit()).isFalse();
        assertThat(look.linear()).isTrue();
        assertThat(look.textures()).isEmpty();
    }

    @Test
    void shouldReadWhatTheFileSays() {
        DisplayMaterial look = look("{\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0,1,0.25],"
                + "\"metallicFactor\":0.5,\"roughnessFactor\":2},\"alphaMode\":\"MASK\",\"alphaCutoff\":0.75,"
                + "\"doubleSided\":true,\"emissiveFactor\":[1,0.5,0],\"extensions\":{\"KHR_materials_unlit\":{},"
                + "\"KHR_materials_emissive_strength\":{\"emissiveStrength\":4},\"KHR_materials_ior\":{\"ior\":2},"
                + "\"KHR_materials_clearcoat\":{\"clearcoatFactor\":0.5,\"clearcoatRoughnessFactor\":0.25}}}");
        assertThat(look.colour()).containsExactly(.5f, 0f, 1f, .25f);
        assertThat(look.metallic()).isEqualTo(.5f);
        assertThat(look.roughness()).isEqualTo(1);
        assertThat(look.alpha()).isEqualTo(DisplayMaterial.Alpha.MASK);
        assertThat(look.cutoff()).isEqualTo(.75f);
        assertThat(look.doubleSided()).isTrue();
        assertThat(look.unlit()).isTrue();
        assertThat(look.emission()).containsExactly(4f, 2f, 0f);
        assertReflects(look, 1 / 9f, 1 / 9f, 1 / 9f, 1);
        assertThat(look.coat()).containsExactly(.5f, .25f);
    }

    @Test
    void shouldReadWhatASurfaceReflects() {
        String specular = "{\"extensions\":{\"KHR_materials_ior\":{\"ior\":3},"
                + "\"KHR_materials_specular\":{\"specularFactor\":0.5,\"specularColorFactor\":[1,0.4,8]}}}";
        assertReflects(look(specular), .125f, .05f, .5f, .5f);
        String glossy = "{\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{\"specularFactor\":[0.2,0.4,0.1]}}}";
        assertReflects(look(glossy), .2f, .4f, .1f, 1);
        assertReflects(look(glossy.replace("[0.2,0.4,0.1]", "7")), 1, 1, 1, 1);
    }

    private static void assertReflects(DisplayMaterial look, float... expected) {
        for (int k = 0; k < 4; k++) assertThat(look.reflectance().get(k)).isCloseTo(expected[k], within(1e-6f));
    }

    @Test
    void shouldReadHowImagesAreUsed() {
        DisplayMaterial look = look(
                "{\"normalTexture\":{\"index\":{\"source\":1,\"sampler\":{\"magFilter\":9728,\"wrapS\":33071}},"
                        + "\"texCoord\":1,\"scale\":0.5},\"pbrMetallicRoughness\":{\"metallicRoughnessTexture\":{\"index\":"
                        + "{\"extensions\":{\"EXT_texture_webp\":{\"source\":0}}},\"extensions\":{\"KHR_texture_transform\":"
                        + "{\"offset\":[0.25,0.5],\"scale\":[2,3],\"rotation\":1.5707963267948966}}}}}",
                "a.webp",
                "b.png");
        TextureUse normal = look.textures().get(Slot.NORMAL);
        assertThat(normal.path()).isEqualTo("b.png");
        assertThat(normal.set()).isEqualTo(1);
        assertThat(normal.factor()).isEqualTo(.5f);
        assertThat(normal.sampler()).isEqualTo(new TextureUse.Sampler(9728, 9987, 33071, 10497));
        TextureUse metal = look.textures().get(Slot.METALLIC);
        assertThat(metal.path()).isEqualTo("a.webp");
        assertThat(metal.channel()).isEqualTo(2);
        // The matrix of the extension's text, for a turn of 90 degrees.
        float[] expected = {0, 3, .25f, -2, 0, .5f};
        for (int i = 0; i < 6; i++) assertThat(metal.transform().get(i)).isCloseTo(expected[i], within(1e-6f));
        assertThat(look.textures().get(Slot.ROUGHNESS).channel()).isEqualTo(1);
    }

    @Test
    void shouldShowTheDiffusePartOfGlossyMaterials() {
        DisplayMaterial look = look(
                "{\"extensions\":{\"KHR_materials_pbrSpecularGlossiness\":{\"diffuseFactor\":[0,1,0,1],"
                        + "\"glossinessFactor\":0.75,\"diffuseTexture\":{\"index\":{\"source\":0}}}}}",
                "a.png");
        assertThat(look.colour()).containsExactly(0f, 1f, 0f, 1f);
        assertThat(look.metallic()).isZero();
        assertThat(look.roughness()).isEqualTo(.25f);
        assertThat(look.image(Slot.COLOUR)).isEqualTo("a.png");
    }

    @Test
    void shouldPreferTheCorePartOfAMaterialThatSaysBoth() {
        DisplayMaterial look = look("{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,1]},\"extensions\":"
                + "{\"KHR_materials_pbrSpecularGlossiness\":{\"diffuseFactor\":[0,0,1,1]}}}");
        assertThat(look.colour()).containsExactly(1f, 0f, 0f, 1f);
        assertThat(look.metallic()).isEqualTo(1);
    }

    @Test
    void shouldLeaveOutImagesOnCoordinatesThatNoViewerGets() {
        String info = "{\"normalTexture\":{\"index\":{\"source\":0},\"texCoord\":%s}}";
        assertThat(look(info.formatted("3"), "a.png").textures()).hasSize(1);
        assertThat(look(info.formatted("4"), "a.png").textures()).isEmpty();
    }

    @Test
    void shouldTakeWhatIsNoDefinitionForAnEmptyOne() {
        DisplayMaterial plain = look("{}");
        for (String text : new String[] {
            "nonsense",
            "[",
            "{\"a\":",
            "{\"a\":1,}",
            "[1]",
            "{} x",
            "{\"alphaMode\":{}}",
            "{\"a\":\"\\u12\"}",
            "{\"emissiveFactor\":[1,2]}",
            "{\"normalTexture\":{\"index\":{\"source\":7}}}",
            "[".repeat(100_000)
        }) assertThat(look(text)).as(text).isEqualTo(plain);
    }

    @Test
    void shouldGiveColoursOfAScreenToProgramsWithoutImages() {
        float[] plain = look("{\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.21586,0,1,0.5]}}")
                .plain();
        assertThat(plain[0]).isCloseTo(.502f, within(1e-3f));
        assertThat(plain[1]).isZero();
        assertThat(plain[2]).isCloseTo(1, within(1e-6f));
        assertThat(plain[3]).isEqualTo(1);
    }

    private static DisplayMaterial look(String gltf, String... paths) {
        List<TextureReference> images = java.util.Arrays.stream(paths)
                .map(p -> new TextureReference("t", p))
                .toList();
        return DisplayMaterial.of(new Material("m", List.of(), images, gltf), false);
    }
}
