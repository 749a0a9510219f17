package org.jsmesh.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.jsmesh.display.DisplayMaterial;
import org.junit.jupiter.api.Test;

class LinearColourTest {
    @Test
    void shouldTurnScreenColoursIntoLinearLight() {
        DisplayMaterial mtl = look(List.of(0f, .5f, 1f, .5f), false, null);
        assertThat(LinearColour.of(mtl, false)).containsExactly(new float[] {0, .21404114f, 1, .5f}, within(1e-6f));
    }

    @Test
    void shouldKeepTheLinearColoursOfGltf() {
        DisplayMaterial gltf = look(List.of(0f, .5f, 1f, 1f), true, null);
        assertThat(LinearColour.of(gltf, false)).containsExactly(0, .5f, 1, 1);
        assertThat(LinearColour.of(gltf, true)).containsExactly(0, .5f, 1, 1);
    }

    @Test
    void shouldGiveTheColourOfClayToModelsWithoutColour() {
        assertThat(LinearColour.of(look(null, false, null), false))
                .containsExactly(new float[] {.5070785f, .46236134f, .39312318f, 1}, within(1e-6f));
    }

    @Test
    void shouldTurnEmissionIntoLinearLightButForGltf() {
        List<Float> light = List.of(0f, .5f, 1f);
        DisplayMaterial mtl = look(null, false, light);
        assertThat(LinearColour.emission(mtl)).containsExactly(new float[] {0, .21404114f, 1}, within(1e-6f));
        DisplayMaterial gltf = look(null, true, light);
        assertThat(LinearColour.emission(gltf)).containsExactly(0, .5f, 1);
        DisplayMaterial none = look(null, true, null);
        assertThat(LinearColour.emission(none)).containsExactly(0, 0, 0);
    }

    private static DisplayMaterial look(List<Float> colour, boolean linear, List<Float> emission) {
        return new DisplayMaterial(
                colour,
                linear,
                -1,
                -1,
                List.of(.04f, .04f, .04f, 1f),
                null,
                emission,
                DisplayMaterial.Alpha.OPAQUE,
                .5f,
                true,
                false,
                Map.of());
    }
}
