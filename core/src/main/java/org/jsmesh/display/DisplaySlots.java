package org.jsmesh.display;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Material;

/**
 * The display materials of a model: materials that look alike share a slot, so that a model with a thousand materials
 * of one colour is drawn at once. Slot 0 is for faces without a material. Translucent slots come last, so that whoever
 * draws in the order of slots draws them over what is behind them.
 *
 * @param materials one per slot, each once
 * @param ofMaterial slot of each material of the model
 */
public record DisplaySlots(List<DisplayMaterial> materials, int[] ofMaterial) {
    /**
     * The slots of a model's materials.
     *
     * @param materials of the model, in the order of their ids; there may be none
     * @param vertexColours whether the model has colours per wedge, which a material without colour shows unchanged
     * @return at least one slot, as there may always be faces without a material
     */
    public static DisplaySlots of(List<Material> materials, boolean vertexColours) {
        List<DisplayMaterial> displayed = new ArrayList<>();
        for (Material material : materials) displayed.add(DisplayMaterial.of(material, vertexColours));
        Map<DisplayMaterial, Integer> slots = new LinkedHashMap<>();
        slots.put(DisplayMaterial.ofNone(vertexColours), 0);
        for (DisplayMaterial material : displayed) if (material.isOpaque()) add(material, slots);
        for (DisplayMaterial material : displayed) add(material, slots);
        int[] ofMaterial = new int[materials.size()];
        for (int i = 0; i < ofMaterial.length; i++) ofMaterial[i] = slots.get(displayed.get(i));
        return new DisplaySlots(new ArrayList<>(slots.keySet()), ofMaterial);
    }

    private static void add(DisplayMaterial material, Map<DisplayMaterial, Integer> slots) {
        if (!slots.containsKey(material)) slots.put(material, slots.size());
    }

    int size() {
        return materials.size();
    }

    /**
     * Finds the slot in which a face is drawn.
     *
     * @param material id of its material in the model, negative for none
     * @return the slot, 0 for faces without a material
     */
    public int slot(int material) {
        return material < 0 ? 0 : ofMaterial[material];
    }

    /** The groups of {@link RenderMesh}. */
    int[] groups(int[] faceMaterials) {
        int[] groups = new int[3 * size()];
        for (int material : faceMaterials) groups[3 * slot(material) + 2] += 3;
        int start = 0;
        for (int s = 0; s < size(); s++) {
            groups[3 * s] = s;
            groups[3 * s + 1] = start;
            start += groups[3 * s + 2];
        }
        return groups;
    }

    /** Where the indices of each face start: a counting sort, so that faces of a slot keep their order. */
    int[] firstIndices(int[] faceMaterials, int[] groups) {
        int[] next = new int[size()];
        for (int s = 0; s < next.length; s++) next[s] = groups[3 * s + 1];
        int[] first = new int[faceMaterials.length];
        for (int f = 0; f < first.length; f++) {
            int slot = slot(faceMaterials[f]);
            first[f] = next[slot];
            next[slot] += 3;
        }
        return first;
    }
}
