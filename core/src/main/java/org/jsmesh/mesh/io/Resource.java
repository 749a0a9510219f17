package org.jsmesh.mesh.io;

/**
 * A file that a model file refers to, as it was found.
 *
 * @param path where it is, with {@code /}, relative to the model file; perhaps not the path that the model file gives
 * @param content its bytes, shared
 */
public record Resource(String path, byte[] content) {}
