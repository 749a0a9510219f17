package org.jsmesh.mesh;

/**
 * The verbatim bytes of an image file that materials refer to.
 *
 * @param path the path as the materials give it
 * @param bytes the file's content, shared
 */
public record Texture(String path, byte[] bytes) {}
