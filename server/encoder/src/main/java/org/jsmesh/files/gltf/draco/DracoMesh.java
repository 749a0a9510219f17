package org.jsmesh.files.gltf.draco;

import java.util.Map;

/**
 * A decoded Draco mesh.
 *
 * @param indices three points for each triangle, each at least 0 and less than {@code points}
 * @param points number of points, for each of which every attribute has a value
 * @param attributes by their unique ids, which glTF refers to
 */
public record DracoMesh(int[] indices, int points, Map<Integer, DracoAttribute> attributes) {
    /**
     * Looks an attribute up.
     *
     * @param uniqueId as glTF has it
     * @return the attribute, or null if there is none
     */
    public DracoAttribute attribute(int uniqueId) {
        return attributes.get(uniqueId);
    }
}
