package org.jsmesh.display;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Material;

/**
 * The display slots of a model: materials that look alike share one, so that a model with a thousand materials of one
 * colour is drawn at once. Slot 0 is for faces without a material.
 */
public final class DisplaySlots {
    private final List<Material> examples;
    private final int[] ofMaterial;
    private final boolean vertexColours;
    private List<DisplayMaterial> looks;

    private DisplaySlots(List<Material> examples, int[] ofMaterial, boolean vertexColours) {
        this.examples = examples;
        this.ofMaterial = ofMaterial;
        this.vertexColours = vertexColours;
    }

    /**
     * The slots of a model's materials.
     *
     * @param materials of the model, in the order of their ids; there may be none
     * @param vertexColours whether the model has colours per wedge, which a material without colour shows unchanged
     * @return at least one slot, as there may always be faces without a material
     */
    public static DisplaySlots of(List<Material> materials, boolean vertexColours) {
        List<Material> examples = new ArrayList<>();
        Map<String, Integer> slots = new HashMap<>();
        examples.add(null);
        slots.put(LookKey.of(null, vertexColours), 0);
        int[] ofMaterial = new int[materials.size()];
        for (int i = 0; i < ofMaterial.length; i++) {
            Material material = materials.get(i);
            String look = LookKey.of(material, vertexColours);
            Integer slot = slots.get(look);
            if (slot == null) {
                slot = examples.size();
                slots.put(look, slot);
                examples.add(material);
            }
            ofMaterial[i] = slot;
        }
        return new DisplaySlots(examples, ofMaterial, vertexColours);
    }

    /** {@return the number of slots} */
    public int size() {
        return examples.size();
    }

    /**
     * One of the materials that share a slot.
     *
     * @param slot which one
     * @return the first of them in the order of ids, or null for slot 0
     */
    public Material example(int slot) {
        return examples.get(slot);
    }

    /** {@return the look of each slot} */
    public synchronized List<DisplayMaterial> materials() {
        if (looks == null) {
            List<DisplayMaterial> all = new ArrayList<>();
            for (Material example : examples) all.add(DisplayMaterial.of(example, vertexColours));
            looks = List.copyOf(all);
        }
        return looks;
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
