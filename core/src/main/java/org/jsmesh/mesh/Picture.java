package org.jsmesh.mesh;

/**
 * An image as colours. A viewer shows it in place of a {@link Texture} that has not arrived; an encoder learns from it
 * what a texture shows.
 *
 * @param path of the texture, as materials name it
 * @param width in pixels
 * @param height in pixels
 * @param argb alpha, red, green, blue per pixel from the highest byte on, not premultiplied; row by row from the top.
 *     Shared
 */
public record Picture(String path, int width, int height, int[] argb) {
    /**
     * Checks the size.
     *
     * @param path see {@link #path()}
     * @param width see {@link #width()}
     * @param height see {@link #height()}
     * @param argb see {@link #argb()}
     * @throws IllegalArgumentException when there are not width × height colours
     */
    public Picture {
        if (width < 1 || height < 1 || argb.length != (long) width * height)
            throw new IllegalArgumentException(argb.length + " colours for " + width + " x " + height);
    }
}
