/** Decodes the compressed meshes of KHR_draco_mesh_compression. */
package org.jsmesh.files.gltf.draco;
