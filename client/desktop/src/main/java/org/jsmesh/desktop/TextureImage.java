package org.jsmesh.desktop;

/**
 * A decoded image.
 *
 * @param width in pixels
 * @param height in pixels
 * @param argb 8 bits each, rows from the top
 */
record TextureImage(int width, int height, int[] argb) {}
