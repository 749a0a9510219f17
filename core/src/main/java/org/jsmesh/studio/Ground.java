package org.jsmesh.studio;

/**
 * What is seen behind the model on page, poster and window: a soft light spot on grey, the same whatever the page's
 * theme. It is an ellipse around a place somewhat above the middle, as CSS has it with {@code radial-gradient(at 50%
 * 42%, …)}.
 */
public final class Ground {
    private static final int[] MIDDLE = {0xdd, 0xe1, 0xe5};
    private static final int[] CORNER = {0xc3, 0xc8, 0xce};
    private static final double ACROSS = .5;
    private static final double DOWN = .42;

    private Ground() {}

    /**
     * The colour at a place of the picture.
     *
     * @param across 0 at the left edge, 1 at the right one
     * @param down 0 at the upper edge, 1 at the lower one
     * @return red, green, blue as sRGB, each 0 to 255
     */
    public static double[] colour(double across, double down) {
        double x = (across - ACROSS) / Math.max(ACROSS, 1 - ACROSS);
        double y = (down - DOWN) / Math.max(DOWN, 1 - DOWN);
        double part = Math.min(1, Math.sqrt((x * x + y * y) / 2));
        double[] rgb = new double[3];
        for (int k = 0; k < 3; k++) rgb[k] = MIDDLE[k] + part * (CORNER[k] - MIDDLE[k]);
        return rgb;
    }

    /**
     * The lightest colour.
     *
     * @return red, green, blue as sRGB, each 0 to 1
     */
    public static float[] middle() {
        return shares(MIDDLE);
    }

    /**
     * The colour of the farthest corner.
     *
     * @return red, green, blue as sRGB, each 0 to 1
     */
    public static float[] corner() {
        return shares(CORNER);
    }

    /**
     * Where the ground is lightest.
     *
     * @return 0 to 1 from the left edge, and from the upper one
     */
    public static float[] spot() {
        return new float[] {(float) ACROSS, (float) DOWN};
    }

    private static float[] shares(int[] rgb) {
        return new float[] {rgb[0] / 255f, rgb[1] / 255f, rgb[2] / 255f};
    }
}
