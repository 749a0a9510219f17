package org.jsmesh.studio;

import java.util.List;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.LinearLight;

/** Colours of materials in linear light, as shaders take them. */
public final class LinearColour {
    /** sRGB of models without any colour, as on the page. */
    private static final List<Float> CLAY = List.of(.74f, .71f, .66f, 1f);

    private LinearColour() {}

    /**
     * The colour that multiplies image and vertex colours.
     *
     * @param material any
     * @param imageShown whether the image of the texture has arrived
     * @return red, green, blue, opacity, each 0 to 1
     */
    public static float[] of(DisplayMaterial material, boolean imageShown) {
        List<Float> colour = material.colour(imageShown);
        boolean isLinear = colour != null && material.linear();
        List<Float> given = colour == null ? CLAY : colour;
        float[] linear = new float[4];
        for (int k = 0; k < 3; k++) linear[k] = isLinear ? given.get(k) : linear(given.get(k));
        linear[3] = given.get(3);
        return linear;
    }

    /**
     * The light that a material sends out.
     *
     * @param material any
     * @return red, green, blue, zeros for none
     */
    public static float[] emission(DisplayMaterial material) {
        float[] linear = new float[3];
        for (int k = 0; k < 3 && material.emission() != null; k++) {
            float given = material.emission().get(k);
            linear[k] = material.linear() ? given : linear(given);
        }
        return linear;
    }

    /**
     * Linear light of an sRGB value (IEC 61966-2-1).
     *
     * @param srgb any number
     * @return 0 to 1
     */
    public static float linear(float srgb) {
        double s = Math.max(0, Math.min(1, srgb));
        return (float) LinearLight.light(s);
    }
}
