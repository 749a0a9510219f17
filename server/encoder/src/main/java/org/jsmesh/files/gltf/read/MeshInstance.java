package org.jsmesh.files.gltf.read;

/**
 * The place of a mesh.
 *
 * @param mesh its number
 * @param name of the node or the mesh, or empty
 * @param isMorphed does the file show it in another shape than that of its vertices?
 * @param hasBytes do bytes of the file say where it is, and no other instance?
 */
record MeshInstance(int mesh, Transform transform, String name, boolean isMorphed, boolean hasBytes) {}
