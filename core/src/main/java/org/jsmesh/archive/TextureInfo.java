package org.jsmesh.archive;

/**
 * An image in an archive.
 *
 * @param path in the materials
 * @param bytes of the image file
 */
public record TextureInfo(String path, int bytes) {}
