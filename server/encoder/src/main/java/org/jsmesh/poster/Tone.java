package org.jsmesh.poster;

import org.jsmesh.studio.Lighting;

/** Light as values of a screen: Khronos' neutral tone mapping, then sRGB. */
final class Tone {
    private static final double START = .8 - .04;
    private static final int STEPS = 4096;

    /** sRGB of linear light, in 0 to 255. */
    private static final float[] SCREEN = new float[STEPS + 2];

    static {
        for (int i = 0; i < SCREEN.length; i++) {
            double light = Math.min(1, (double) i / STEPS);
            SCREEN[i] =
                    (float) (255 * (light <= .0031308 ? 12.92 * light : 1.055 * StrictMath.pow(light, 1 / 2.4) - .055));
        }
    }

    private Tone() {}

    /**
     * Turns red, green, blue of linear light into sRGB of 0 to 255. Colours below .8 stay, brighter ones near white.
     */
    static void map(double[] rgb) {
        for (int k = 0; k < 3; k++) rgb[k] *= Lighting.EXPOSURE;
        double least = Math.min(rgb[0], Math.min(rgb[1], rgb[2]));
        double off = least < .08 ? least - 6.25 * least * least : .04;
        for (int k = 0; k < 3; k++) rgb[k] -= off;
        double peak = Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
        if (peak >= START) {
            double room = 1 - START;
            double lower = 1 - room * room / (peak + room - START);
            double white = 1 - 1 / (.15 * (peak - lower) + 1);
            for (int k = 0; k < 3; k++) {
                double c = rgb[k] * lower / peak;
                rgb[k] = c + white * (lower - c);
            }
        }
        for (int k = 0; k < 3; k++) rgb[k] = screen(rgb[k]);
    }

    private static double screen(double light) {
        double at = Math.max(0, Math.min(1, light)) * STEPS;
        int step = (int) at;
        return SCREEN[step] + (at - step) * (SCREEN[step + 1] - SCREEN[step]);
    }
}
