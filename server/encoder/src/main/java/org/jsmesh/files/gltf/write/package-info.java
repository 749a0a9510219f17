/** Writes meshes as GLB. */
package org.jsmesh.files.gltf.write;
