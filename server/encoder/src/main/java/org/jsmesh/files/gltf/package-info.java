/** Reads glTF 2.0 as one baked mesh and writes meshes as GLB. */
package org.jsmesh.files.gltf;
