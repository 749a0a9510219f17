package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Material.Parameter;
import org.jsmesh.mesh.Material.TextureReference;
import org.junit.jupiter.api.Test;

class DisplayMaterialTest {
    private static final TextureReference MTL_IMAGE = new TextureReference("map_Kd", "0.png");
    private static final TextureReference GLTF_IMAGE = new TextureReference("baseColorTexture", "0.png");
    private static final Parameter RED = new Parameter("Kd", 1, 0, 0);
    private static final Parameter BLACK = new Parameter("Kd", 0, 0, 0);
    private static final Parameter HALF = new Parameter("d", .5f);

    @Test
    void shouldShowVertexColoursUnchangedWithoutAColourOfItsOwn() {
        assertThat(DisplayMaterial.ofNone(false).colour()).isNull();
        assertThat(DisplayMaterial.ofNone(true).colour()).containsExactly(1f, 1f, 1f, 1f);
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
    void shouldMultiplyTheImageOfGltfWithItsColour() {
        Parameter factor = new Parameter("baseColorFactor", .5f, 0, 0, 1);
        assertThat(material(false, List.of(factor), GLTF_IMAGE).colour(true)).containsExactly(.5f, 0f, 0f, 1f);
        Parameter none = new Parameter("baseColorFactor", 0, 0, 0, 1);
        assertThat(material(false, List.of(none), GLTF_IMAGE).colour(true)).containsExactly(0f, 0f, 0f, 1f);
        assertThat(material(false, List.of(), GLTF_IMAGE).colour(true)).containsExactly(1f, 1f, 1f, 1f);
    }

    @Test
    void shouldKeepTheOpacityOfAMaterialWithoutColour() {
        DisplayMaterial material = material(false, List.of(HALF));
        assertThat(material.isOpaque()).isFalse();
        assertThat(material.colour()).containsExactly(.8f, .8f, .8f, .5f);
    }

    private static DisplayMaterial material(
            boolean vertexColours, List<Parameter> parameters, TextureReference... textures) {
        return DisplayMaterial.of(new Material("m", parameters, List.of(textures)), vertexColours);
    }
}
