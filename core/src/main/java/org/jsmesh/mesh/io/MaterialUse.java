package org.jsmesh.mesh.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.Material;

/** Materials that faces use. A shared library may define many more, which are no part of the mesh. */
final class MaterialUse {
    private final int[] faceMaterials;
    private final List<Material> materials = new ArrayList<>();

    /**
     * @param ids material of each face, −1 for none
     * @param definitions of all ids
     */
    MaterialUse(int[] ids, List<Material> definitions) {
        int[] newIds = new int[definitions.size()];
        boolean[] used = new boolean[definitions.size()];
        for (int id : ids) {
            if (id >= 0) used[id] = true;
        }
        Arrays.fill(newIds, -1);
        for (int id = 0; id < newIds.length; id++) {
            if (!used[id]) continue;
            newIds[id] = materials.size();
            materials.add(definitions.get(id));
        }
        faceMaterials = new int[ids.length];
        for (int f = 0; f < ids.length; f++) faceMaterials[f] = ids[f] < 0 ? -1 : newIds[ids[f]];
    }

    int[] faceMaterials() {
        return faceMaterials;
    }

    List<Material> materials() {
        return materials;
    }
}
