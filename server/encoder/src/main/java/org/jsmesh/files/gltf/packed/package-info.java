/** Decodes the compressed buffer views of EXT_meshopt_compression and KHR_meshopt_compression. */
package org.jsmesh.files.gltf.packed;
