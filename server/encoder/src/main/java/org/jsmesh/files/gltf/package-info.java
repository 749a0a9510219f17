/** Reads glTF 2.0 as one baked mesh. */
package org.jsmesh.files.gltf;
