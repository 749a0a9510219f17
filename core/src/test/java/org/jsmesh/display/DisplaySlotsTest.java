package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jsmesh.mesh.Material;
import org.junit.jupiter.api.Test;

class DisplaySlotsTest {
    private static final Material RED = coloured("red", 1, 0, 0);

    @Test
    void shouldShareASlotAmongMaterialsThatLookAlike() {
        DisplaySlots slots = DisplaySlots.of(List.of(RED, coloured("blue", 0, 0, 1), coloured("also red", 1, 0, 0)));
        assertThat(slots.size()).isEqualTo(3);
        assertThat(slots.slot(0)).isEqualTo(slots.slot(2)).isNotEqualTo(slots.slot(1));
        assertThat(slots.slot(-1)).isZero();
    }

    @Test
    void shouldLeaveColourToTheViewerWhenAMaterialHasNone() {
        DisplaySlots slots = DisplaySlots.of(List.of(Material.named("plain")));
        assertThat(slots.size()).isEqualTo(1);
        assertThat(slots.looks().get(0).colour()).isNull();
    }

    @Test
    void shouldTellTexturesOfGltfFromThoseOfMtl() {
        Material gltf =
                new Material("a", List.of(), List.of(new Material.TextureReference("baseColorTexture", "0.png")));
        Material mtl = new Material("b", List.of(), List.of(new Material.TextureReference("map_Kd", "0.png")));
        DisplaySlots slots = DisplaySlots.of(List.of(gltf, mtl));
        assertThat(slots.looks().get(slots.slot(0)).gltf()).isTrue();
        assertThat(slots.looks().get(slots.slot(1)).gltf()).isFalse();
        assertThat(slots.looks()).extracting(DisplaySlots.Look::texture).containsExactly(null, "0.png", "0.png");
    }

    private static Material coloured(String name, float r, float g, float b) {
        return new Material(name, List.of(new Material.Parameter("Kd", r, g, b)), List.of());
    }
}
