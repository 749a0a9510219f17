package org.jsmesh.display;

import java.util.List;
import org.jsmesh.mesh.Material;

/**
 * Texts that are equal where materials look alike. Records would do, but their {@code equals} brings a browser's
 * decoder that of all collections.
 */
final class LookKey {
    private static final char END = '\n';

    private final StringBuilder key = new StringBuilder();

    private LookKey() {}

    /** Definitions of glTF look alike when they are equal: here nobody reads them. */
    static String of(Material material, boolean vertexColours) {
        LookKey look = new LookKey();
        if (material == null || !material.isGltf()) look.add(DisplayMaterial.ofOther(material, vertexColours));
        else look.addGltf(material);
        return look.key.toString();
    }

    private void addGltf(Material material) {
        key.append('g');
        add(material.gltf());
        for (Material.TextureReference t : material.textures()) {
            add(t.key());
            add(t.path());
        }
    }

    /** What all materials of other formats than glTF have in common is not asked for. */
    private void add(DisplayMaterial look) {
        add(look.colour());
        add(look.metallic());
        add(look.roughness());
        add(look.emission());
        for (Slot slot : Slot.values()) {
            TextureUse use = look.textures().get(slot);
            if (use != null) addUse(slot, use);
        }
    }

    private void addUse(Slot slot, TextureUse use) {
        add(slot.ordinal());
        add(use.path());
        add(use.sampler() == TextureUse.Sampler.CLAMPED ? 1 : 0);
        add(use.transform());
        add(use.factor());
        add(use.channel());
    }

    private void add(String text) {
        key.append(text.length()).append(END).append(text);
    }

    private void add(List<Float> numbers) {
        int count = numbers == null ? 0 : numbers.size();
        add(count);
        for (int i = 0; i < count; i++) add(numbers.get(i));
    }

    private void add(float number) {
        key.append(Float.floatToIntBits(number)).append(END);
    }
}
