package org.jsmesh.files.gltf.draco;

/**
 * One attribute of a Draco mesh.
 *
 * @param components numbers per point
 * @param componentType the type of a number as glTF writes it: 5120, 5121, 5122, 5123, 5125 or 5126
 * @param normalized whether integers stand for fractions of their largest value
 * @param values the numbers of one point after the other, little endian, without padding
 */
public record DracoAttribute(int components, int componentType, boolean normalized, byte[] values) {}
