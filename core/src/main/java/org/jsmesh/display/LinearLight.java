package org.jsmesh.display;

/**
 * Linear light as values of a screen (sRGB, IEC 61966-2-1), with arithmetic that gives the same on every platform:
 * powers of the platforms differ in their last bits.
 */
public final class LinearLight {
    private static final int LEVELS = 255;
    private static final int ROOT_STEPS = 60;

    /** Light from which on a pixel has the level 1 .. 255. */
    private static final double[] FROM = new double[LEVELS];

    static {
        for (int i = 0; i < LEVELS; i++) FROM[i] = light((i + .5) / LEVELS);
    }

    private LinearLight() {}

    /**
     * The light of a value of a screen.
     *
     * @param screen 0 to 1
     * @return linear light, 0 to 1
     */
    public static double light(double screen) {
        if (screen <= .04045) return screen / 12.92;
        double x = (screen + .055) / 1.055;
        return x * x * fifthRoot(x * x);
    }

    /**
     * The closest level of a pixel.
     *
     * @param light linear, any number
     * @return 0 to 255
     */
    public static int level(double light) {
        int low = 0;
        int high = LEVELS;
        while (low < high) {
            int middle = low + high >>> 1;
            if (light >= FROM[middle]) low = middle + 1;
            else high = middle;
        }
        return low;
    }

    /** The value of a screen, 0 to 1, for linear light. */
    static float toScreen(float light) {
        double x = Math.max(0, Math.min(1, light));
        if (x <= .0031308) return (float) (12.92 * x);
        double low = 0;
        double high = 1;
        for (int i = 0; i < ROOT_STEPS; i++) {
            double middle = (low + high) / 2;
            if (light(middle) < x) low = middle;
            else high = middle;
        }
        return (float) high;
    }

    /** By Newton's method, from above. */
    private static double fifthRoot(double x) {
        double root = 1;
        for (int i = 0; i < ROOT_STEPS; i++) root = (4 * root + x / (root * root * root * root)) / 5;
        return root;
    }
}
