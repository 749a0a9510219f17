package org.jsmesh.desktop;

/**
 * The light of the scene, in linear light. A surface with albedo a and unit normal n, turned to the viewer, shows
 *
 * <pre>
 * a · (mix(GROUND, SKY, (1 + n·up) / 2) + KEY · max(n·k, 0) + FILL · max(n·f, 0)) + HIGHLIGHT · KEY · max(n·h, 0)^SHININESS
 * </pre>
 *
 * clamped to 1 and encoded as sRGB. {@code up} is +y of the model; k and f stay with the eye (x right, y up, z towards
 * the viewer); h is halfway between k and the direction to the eye (Blinn 1977).
 */
final class Lighting {
    static final float[] SKY = {.27f, .31f, .37f};
    static final float[] GROUND = {.075f, .065f, .06f};
    static final float[] KEY = {1.00f, .96f, .90f};
    static final float[] KEY_DIRECTION = unit(-.6, .75, .6);
    static final float[] FILL = {.12f, .14f, .18f};
    static final float[] FILL_DIRECTION = unit(.8, -.1, .45);
    static final float HIGHLIGHT = .10f;
    static final float SHININESS = 28;

    /** sRGB of the background at the lower and the upper edge. */
    static final float[] BACKGROUND_BOTTOM = {.80f, .82f, .85f};

    static final float[] BACKGROUND_TOP = {.95f, .96f, .97f};

    private Lighting() {}

    private static float[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return new float[] {(float) (x / length), (float) (y / length), (float) (z / length)};
    }
}
