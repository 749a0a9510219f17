package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.jsmesh.display.DisplayMaterial;
import org.junit.jupiter.api.Test;

class LinearColourTest {
    @Test
    void shouldTurnScreenColoursIntoLinearLight() {
        DisplayMaterial mtl = new DisplayMaterial(List.of(0f, .5f, 1f, .5f), null, false, -1, -1);
        assertThat(LinearColour.of(mtl, false)).containsExactly(new float[] {0, .21404114f, 1, .5f}, within(1e-6f));
    }

    @Test
    void shouldKeepTheLinearColoursOfGltf() {
        DisplayMaterial gltf = new DisplayMaterial(List.of(0f, .5f, 1f, 1f), "0.png", true, -1, -1);
        assertThat(LinearColour.of(gltf, false)).containsExactly(0, .5f, 1, 1);
        assertThat(LinearColour.of(gltf, true)).containsExactly(0, .5f, 1, 1);
    }

    @Test
    void shouldGiveGreyToModelsWithoutColour() {
        float grey = .6038274f;
        DisplayMaterial plain = new DisplayMaterial(null, null, false, -1, -1);
        assertThat(LinearColour.of(plain, false)).containsExactly(new float[] {grey, grey, grey, 1}, within(1e-6f));
    }
}
