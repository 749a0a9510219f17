/** JSON as a tree that keeps the texts of numbers. */
package org.jsmesh.files.gltf.json;
