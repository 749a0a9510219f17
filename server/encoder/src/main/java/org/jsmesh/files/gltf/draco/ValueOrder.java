package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedException;

/**
 * Which values an attribute has, in the order of the stream.
 *
 * @param table null for a mesh without one, where the values are those of the points in order
 * @param corners a corner for each value
 * @param entryOfVertex the value at each vertex of the table
 */
record ValueOrder(CornerTable table, int[] corners, int[] entryOfVertex) {
    /** The value at a corner. */
    int entry(int corner) throws PackedException {
        int vertex = table.vertex(corner);
        if (vertex == CornerTable.NONE) throw new PackedException("a corner of the Draco mesh has no vertex");
        return entryOfVertex[vertex];
    }
}
