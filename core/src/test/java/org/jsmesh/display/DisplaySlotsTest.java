package org.jsmesh.display;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Material.TextureReference;
import org.junit.jupiter.api.Test;

class DisplaySlotsTest {
    private static final Material RED = coloured("red", 1, 0, 0);
    private static final String IMAGE = "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":{\"source\":0}}}}";

    @Test
    void shouldShareASlotAmongMaterialsThatLookAlike() {
        DisplaySlots slots = slots(RED, coloured("blue", 0, 0, 1), coloured("also red", 1, 0, 0));
        assertThat(slots.size()).isEqualTo(3);
        assertThat(slots.slot(0)).isEqualTo(slots.slot(2)).isNotEqualTo(slots.slot(1));
        assertThat(slots.slot(-1)).isZero();
        assertThat(slots.groups(new int[] {0, 2, 1, -1})).containsExactly(0, 0, 3, 1, 3, 6, 2, 9, 3);
    }

    @Test
    void shouldShareASlotAmongEqualDefinitionsOfGltf() {
        DisplaySlots slots = slots(gltf("a", "0.png"), gltf("b", "1.png"), gltf("c", "0.png"));
        assertThat(slots.size()).isEqualTo(3);
        assertThat(slots.slot(0)).isEqualTo(slots.slot(2)).isNotEqualTo(slots.slot(1));
        assertThat(slots.example(0)).isNull();
        assertThat(slots.example(1).name()).isEqualTo("a");
    }

    @Test
    void shouldTellMaterialsThatDifferInOneNumberOrImage() {
        Material[] all = {
            mtl("map_Kd", "0.png", new Material.Parameter("Pm", 0)),
            mtl("map_Kd", "0.png", new Material.Parameter("Pm", 1)),
            mtl("map_Kd", "0.png", new Material.Parameter("Pr", 0)),
            mtl("map_Kd", "0.png", new Material.Parameter("Ke", 0, 0, 1)),
            mtl("map_Kd", "0.png", new Material.Parameter("d", .5f)),
            mtl("map_Kd", "0.png", new Material.Parameter("map_Kd -s", 2, 2, 2)),
            mtl("map_Kd", "0.png", new Material.Parameter("map_Kd -clamp on")),
            mtl("map_Kd", "1.png", new Material.Parameter("Pm", 0)),
            mtl("map_Ke", "0.png", new Material.Parameter("Pm", 0))
        };
        assertThat(slots(all).size()).isEqualTo(1 + all.length);
        DisplaySlots twice = slots(all[4], all[0], mtl("map_Kd", "0.png", new Material.Parameter("d", .5f)));
        assertThat(twice.size()).isEqualTo(3);
        assertThat(twice.slot(2)).isEqualTo(twice.slot(0));
    }

    @Test
    void shouldLeaveColourToTheViewerWhenAMaterialHasNone() {
        DisplaySlots slots = slots(Material.named("plain"));
        assertThat(slots.size()).isEqualTo(1);
        assertThat(slots.materials().get(0).colour()).isNull();
    }

    @Test
    void shouldTellTexturesOfGltfFromThoseOfMtl() {
        Material mtl = new Material("b", List.of(), List.of(new TextureReference("map_Kd", "0.png")));
        DisplaySlots slots = slots(gltf("a", "0.png"), mtl);
        assertThat(slots.materials().get(slots.slot(0)).linear()).isTrue();
        assertThat(slots.materials().get(slots.slot(1)).linear()).isFalse();
        assertThat(slots.materials())
                .extracting(look -> look.image(Slot.COLOUR))
                .containsExactly(null, "0.png", "0.png");
    }

    private static DisplaySlots slots(Material... materials) {
        return DisplaySlots.of(List.of(materials), false);
    }

    private static Material mtl(String use, String path, Material.Parameter parameter) {
        return new Material("", List.of(parameter), List.of(new TextureReference(use, path)));
    }

    private static Material gltf(String name, String path) {
        return new Material(name, List.of(), List.of(new TextureReference("baseColorTexture", path)), IMAGE);
    }

    private static Material coloured(String name, float r, float g, float b) {
        return new Material(name, List.of(new Material.Parameter("Kd", r, g, b)), List.of());
    }
}
