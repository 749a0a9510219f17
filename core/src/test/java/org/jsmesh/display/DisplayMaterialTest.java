package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Material.Parameter;
import org.jsmesh.mesh.Material.TextureReference;
import org.junit.jupiter.api.Test;

class DisplayMaterialTest {
    private static final TextureReference MTL_IMAGE = new TextureReference("map_Kd", "0.png");
    private static final Parameter RED = new Parameter("Kd", 1, 0, 0);
    private static final Parameter BLACK = new Parameter("Kd", 0, 0, 0);
    private static final Parameter HALF = new Parameter("d", .5f);

    @Test
    void shouldShowVertexColoursUnchangedWithoutAColourOfItsOwn() {
        assertThat(DisplayMaterial.of(null, false).colour()).isNull();
        assertThat(DisplayMaterial.of(null, true).colour()).containsExactly(1f, 1f, 1f, 1f);
        assertThat(material(true, List.of()).colour()).containsExactly(1f, 1f, 1f, 1f);
        assertThat(material(true, List.of(RED)).colour()).containsExactly(1f, 0f, 0f, 1f);
    }

    @Test
    void shouldHideTheColourOfAnMtlUnderItsImage() {
        DisplayMaterial material = material(false, List.of(RED, HALF), MTL_IMAGE);
        assertThat(material.colour(false)).containsExactly(1f, 0f, 0f, .5f);
        assertThat(material.colour(true)).containsExactly(1f, 1f, 1f, .5f);
    }

    @Test
    void shouldShowGreyInPlaceOfABlackUntilTheImageArrives() {
        assertThat(material(false, List.of(BLACK), MTL_IMAGE).colour(false)).containsExactly(.8f, .8f, .8f, 1f);
        assertThat(material(false, List.of(), MTL_IMAGE).colour(false)).containsExactly(.8f, .8f, .8f, 1f);
        assertThat(material(false, List.of(BLACK)).colour(false)).containsExactly(0f, 0f, 0f, 1f);
    }

    @Test
    void shouldKeepTheOpacityOfAMaterialWithoutColour() {
        DisplayMaterial material = material(false, List.of(HALF));
        assertThat(material.isOpaque()).isFalse();
        assertThat(material.colour()).containsExactly(.8f, .8f, .8f, .5f);
    }

    @Test
    void shouldTakeOpacityFromDAndElseFromTr() {
        assertThat(opacity(new Parameter("d", .25f))).isEqualTo(.25f);
        assertThat(opacity(new Parameter("Tr", .25f))).isEqualTo(.75f);
        assertThat(opacity(new Parameter("d", 1), new Parameter("Tr", 0))).isEqualTo(1);
        assertThat(opacity(new Parameter("Tr", .9f), new Parameter("d", .5f))).isEqualTo(.5f);
        assertThat(opacity(new Parameter("d", 7))).isEqualTo(1);
        assertThat(opacity(new Parameter("Tr", 1))).isEqualTo(1);
        assertThat(opacity(new Parameter("Tr", 0))).isEqualTo(1);
    }

    private static float opacity(Parameter... parameters) {
        DisplayMaterial material = material(true, List.of(parameters));
        assertThat(material.isOpaque()).isEqualTo(material.colour().get(3) == 1);
        return material.colour().get(3);
    }

    @Test
    void shouldTakeMetalAndRoughnessFromTheKeysOfTheirFormat() {
        DisplayMaterial chrome = material(false, List.of(new Parameter("Pm", 1), new Parameter("Pr", .1f)));
        assertThat(chrome.metallic()).isEqualTo(1);
        assertThat(chrome.roughness()).isEqualTo(.1f);
        DisplayMaterial plain = material(false, List.of(RED));
        assertThat(plain.metallic()).isEqualTo(-1);
        assertThat(plain.roughness()).isEqualTo(-1);
    }

    @Test
    void shouldTakeRoughnessFromNsWhereThereIsNoOther() {
        assertThat(roughness(new Parameter("Ns", 250))).isEqualTo(.5f);
        assertThat(roughness(new Parameter("Ns", 0))).isEqualTo(1);
        assertThat(roughness(new Parameter("Ns", 1000))).isZero();
        assertThat(roughness(new Parameter("Ns", 5000))).isZero();
        assertThat(roughness(new Parameter("Ns", 250), new Parameter("Pr", .75f)))
                .isEqualTo(.75f);
        assertThat(roughness(new Parameter("Ns", 250), new Parameter("Ks", .5f, .5f, .5f)))
                .isEqualTo(.5f);
        assertThat(roughness(new Parameter("Ns", 250), new Parameter("Ks", 0, 0, 0)))
                .isEqualTo(1);
    }

    private static float roughness(Parameter... parameters) {
        return material(false, List.of(parameters)).roughness();
    }

    @Test
    void shouldGlowWhereEmissionIsNotBlack() {
        Parameter glow = new Parameter("Ke", 0, .9f, .5f);
        assertThat(material(false, List.of(BLACK, glow)).emission()).containsExactly(0f, .9f, .5f);
        assertThat(material(false, List.of(BLACK, glow)).colour()).containsExactly(0f, 0f, 0f, 1f);
        assertThat(material(false, List.of(RED, new Parameter("Ke", 0, 0, 0))).emission())
                .isNull();
        assertThat(material(false, List.of(RED)).emission()).isNull();
    }

    @Test
    void shouldHaveTheMaskThatMapDNames() {
        assertThat(material(false, List.of(RED), MTL_IMAGE, new TextureReference("map_d", "holes.png"))
                        .image(Slot.OPACITY))
                .isEqualTo("holes.png");
        assertThat(material(false, List.of(RED), MTL_IMAGE).image(Slot.OPACITY)).isNull();
        assertThat(material(false, List.of(RED), MTL_IMAGE, new TextureReference("map_d", "0.png"))
                        .image(Slot.OPACITY))
                .isNull();
    }

    private static DisplayMaterial material(
            boolean vertexColours, List<Parameter> parameters, TextureReference... textures) {
        return DisplayMaterial.of(new Material("m", parameters, List.of(textures)), vertexColours);
    }
}
