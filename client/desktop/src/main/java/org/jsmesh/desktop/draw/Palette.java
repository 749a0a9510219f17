package org.jsmesh.desktop.draw;

import java.awt.Color;

/**
 * Colours for numbers, as on the page: the colour map viridis. They go from dark blue over green to yellow, brighter
 * all the way, so that they keep their order for those who see few colours, and in print.
 */
public final class Palette {
    /** At equal distances, sRGB. */
    private static final int[] STOPS = {
        0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725
    };

    private Palette() {}

    /**
     * The colour of a share.
     *
     * @param share of the largest number; below 0 it is 0, above 1 it is 1
     * @return an opaque colour, sRGB
     */
    public static Color of(double share) {
        double at = Math.min(Math.max(share, 0), 1) * (STOPS.length - 1);
        int stop = Math.min((int) at, STOPS.length - 2);
        return new Color(part(stop, at, 16), part(stop, at, 8), part(stop, at, 0));
    }

    private static int part(int stop, double at, int shift) {
        int from = STOPS[stop] >> shift & 255;
        int to = STOPS[stop + 1] >> shift & 255;
        return (int) Math.round(from + (at - stop) * (to - from));
    }

    static int size() {
        return STOPS.length;
    }

    /** Red, green, blue of a stop, 0 to 1. */
    static float[] stop(int i) {
        return new float[] {(STOPS[i] >> 16 & 255) / 255f, (STOPS[i] >> 8 & 255) / 255f, (STOPS[i] & 255) / 255f};
    }
}
