/** Reads glTF 2.0 as one baked mesh: JSON tree, accessors, nodes, primitives, materials. */
package org.jsmesh.files.gltf.read;
