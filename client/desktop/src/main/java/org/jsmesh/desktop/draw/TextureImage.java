package org.jsmesh.desktop.draw;

import org.jsmesh.studio.Opacity;

/**
 * A decoded image.
 *
 * @param width in pixels
 * @param height in pixels
 * @param argb 8 bits each, rows from the top
 * @param opacity what its alpha means
 */
public record TextureImage(int width, int height, int[] argb, Opacity opacity) {
    public static TextureImage of(int width, int height, int[] argb) {
        return new TextureImage(width, height, argb, Opacity.of(argb));
    }

    /** The opacity that it says as a mask, in alpha: its own alpha, or its brightness where it has none. */
    public TextureImage mask() {
        if (opacity != Opacity.OPAQUE) return this;
        int[] mask = new int[argb.length];
        for (int i = 0; i < mask.length; i++) {
            double bright = .2126 * (argb[i] >> 16 & 255) + .7152 * (argb[i] >> 8 & 255) + .0722 * (argb[i] & 255);
            mask[i] = (int) Math.round(bright) << 24;
        }
        return of(width, height, mask);
    }
}
