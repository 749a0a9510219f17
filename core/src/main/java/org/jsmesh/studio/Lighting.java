package org.jsmesh.studio;

/**
 * The light of the scene, the same on page, poster and in the window: a hemisphere, a key lamp over the viewer's left
 * shoulder, and a {@linkplain Studio studio} all around. Numbers are in linear light; a matte surface sends out a πth
 * of what hemisphere and key lamp give it. Up is +y of the scene. The key lamp stays with the eye, for which x points
 * right, y up and z towards the viewer.
 */
public final class Lighting {
    /** Red, green, blue of the hemisphere above. */
    public static final float[] SKY = light(0xffffff, .55);

    /** Red, green, blue of the hemisphere below. */
    public static final float[] GROUND = light(0x8d8478, .55);

    /** Red, green, blue of the key lamp. */
    public static final float[] KEY = light(0xfff4e6, 2.1);

    /** Where the key lamp is, in the eye's axes; of length 1. */
    public static final float[] KEY_DIRECTION = unit(-.6, .9, .7);

    /** What the studio's light is multiplied with. */
    public static final float STUDIO = .45f;

    /** What all light is multiplied with before bright colours are drawn together. */
    public static final float EXPOSURE = .92f;

    /** Roughness where a material does not say it. */
    public static final float PLAIN_ROUGHNESS = .62f;

    private Lighting() {}

    /** @param rgb sRGB */
    private static float[] light(int rgb, double strength) {
        float[] light = new float[3];
        for (int k = 0; k < 3; k++)
            light[k] = (float) (strength * LinearColour.linear((rgb >> 16 - 8 * k & 255) / 255f));
        return light;
    }

    private static float[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return new float[] {(float) (x / length), (float) (y / length), (float) (z / length)};
    }
}
