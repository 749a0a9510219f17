package org.jsmesh.display;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Material;

/**
 * What a renderer needs of materials: those that look alike share a slot, so that a model with a thousand materials of
 * one colour is drawn at once. Slot 0 is for faces without a material.
 *
 * @param looks one per slot
 * @param ofMaterial slot of each material
 */
public record DisplaySlots(List<Look> looks, int[] ofMaterial) {
    private static final float UNKNOWN = -1;
    private static final Look PLAIN = new Look(null, null, false, UNKNOWN, UNKNOWN);

    /**
     * How a slot looks.
     *
     * @param colour red, green, blue, opacity, or null for the viewer's own
     * @param texture path of the colour texture, or null
     * @param gltf true when colours are linear and texture coordinates count from the top, as glTF has them
     * @param metallic 0 to 1, or −1 when the material does not say
     * @param roughness 0 to 1, or −1 when the material does not say
     */
    public record Look(List<Float> colour, String texture, boolean gltf, float metallic, float roughness) {}

    public static DisplaySlots of(List<Material> materials) {
        Map<Look, Integer> slots = new LinkedHashMap<>();
        slots.put(PLAIN, 0);
        int[] ofMaterial = new int[materials.size()];
        for (int i = 0; i < ofMaterial.length; i++) {
            Look look = look(materials.get(i));
            Integer slot = slots.get(look);
            if (slot == null) {
                slot = slots.size();
                slots.put(look, slot);
            }
            ofMaterial[i] = slot;
        }
        return new DisplaySlots(new ArrayList<>(slots.keySet()), ofMaterial);
    }

    int size() {
        return looks.size();
    }

    /** Slot of a face with this material id. */
    int slot(int material) {
        return material < 0 ? 0 : ofMaterial[material];
    }

    private static Look look(Material material) {
        float[] c = material.displayColour();
        String texture = material.displayTexture();
        boolean plain = texture == null && !hasColour(material);
        List<Float> colour = plain ? null : List.of(c[0], c[1], c[2], c[3]);
        return new Look(
                colour, texture, isGltf(material), one(material, "metallicFactor"), one(material, "roughnessFactor"));
    }

    private static boolean hasColour(Material material) {
        return material.parameter("baseColorFactor") != null
                || material.parameter("Kd") != null
                || material.parameter("rgb") != null;
    }

    private static boolean isGltf(Material material) {
        if (material.parameter("baseColorFactor") != null) return true;
        return material.textures().stream().anyMatch(t -> t.key().equals("baseColorTexture"));
    }

    private static float one(Material material, String key) {
        float[] value = material.parameter(key);
        return value == null || value.length != 1 ? UNKNOWN : value[0];
    }
}
