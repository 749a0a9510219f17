package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jsmesh.mesh.Material;
import org.junit.jupiter.api.Test;

class DisplaySlotsTest {
    private static final Material RED = coloured("red", 1, 0, 0);

    @Test
    void shouldShareASlotAmongMaterialsThatLookAlike() {
        DisplaySlots slots = slots(RED, coloured("blue", 0, 0, 1), coloured("also red", 1, 0, 0));
        assertThat(slots.size()).isEqualTo(3);
        assertThat(slots.slot(0)).isEqualTo(slots.slot(2)).isNotEqualTo(slots.slot(1));
        assertThat(slots.slot(-1)).isZero();
    }

    @Test
    void shouldLeaveColourToTheViewerWhenAMaterialHasNone() {
        DisplaySlots slots = slots(Material.named("plain"));
        assertThat(slots.size()).isEqualTo(1);
        assertThat(slots.materials().get(0).colour()).isNull();
    }

    @Test
    void shouldTellTexturesOfGltfFromThoseOfMtl() {
        Material gltf =
                new Material("a", List.of(), List.of(new Material.TextureReference("baseColorTexture", "0.png")));
        Material mtl = new Material("b", List.of(), List.of(new Material.TextureReference("map_Kd", "0.png")));
        DisplaySlots slots = slots(gltf, mtl);
        assertThat(slots.materials().get(slots.slot(0)).gltf()).isTrue();
        assertThat(slots.materials().get(slots.slot(1)).gltf()).isFalse();
        assertThat(slots.materials()).extracting(DisplayMaterial::texture).containsExactly(null, "0.png", "0.png");
    }

    @Test
    void shouldPutTranslucentSlotsLast() {
        Material glass = new Material(
                "glass", List.of(new Material.Parameter("Kd", 1, 1, 1), new Material.Parameter("d", .5f)), List.of());
        DisplaySlots slots = slots(glass, RED);
        assertThat(slots.slot(0)).isEqualTo(2);
        assertThat(slots.slot(1)).isEqualTo(1);
        assertThat(slots.materials()).extracting(DisplayMaterial::isOpaque).containsExactly(true, true, false);
        assertThat(slots.groups(new int[] {0, 0, 1, -1})).containsExactly(0, 0, 3, 1, 3, 3, 2, 6, 6);
    }

    private static DisplaySlots slots(Material... materials) {
        return DisplaySlots.of(List.of(materials), false);
    }

    private static Material coloured(String name, float r, float g, float b) {
        return new Material(name, List.of(new Material.Parameter("Kd", r, g, b)), List.of());
    }
}
