package org.jsmesh.studio;

/** What the opacity of an image means. The page tells it in the same way. */
public enum Opacity {
    /** Nothing: the surface is whole. */
    OPAQUE,
    /** Cut out, so that the order of drawing does not matter. */
    HOLES,
    /** Blended with what is behind it. */
    GLASS;

    /** Alpha from here on is opaque: filters and lossy images are off by a few. */
    private static final int FULL = 250;
    /** Alpha below this is unseen. */
    private static final int SEEN = 16;

    /**
     * A mask has pixels that are seen and pixels that are not, and few between them at its edges. An image that is
     * unseen everywhere has no opacity at all: some programs leave it 0.
     *
     * @param argb pixels with alpha in the highest byte
     * @return what it means
     */
    public static Opacity of(int[] argb) {
        int unseen = 0;
        int between = 0;
        for (int pixel : argb) {
            int alpha = pixel >>> 24;
            if (alpha < SEEN) unseen++;
            else if (alpha < FULL) between++;
        }
        if (unseen + between == 0 || unseen == argb.length) return OPAQUE;
        return between <= unseen ? HOLES : GLASS;
    }
}
