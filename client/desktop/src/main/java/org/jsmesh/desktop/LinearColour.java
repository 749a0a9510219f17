package org.jsmesh.desktop;

import java.util.List;
import org.jsmesh.display.DisplayMaterial;

/** Colours of materials in linear light, as the shader takes them. */
final class LinearColour {
    /** sRGB of models without any colour. */
    private static final List<Float> GREY = List.of(.8f, .8f, .8f, 1f);

    private LinearColour() {}

    /**
     * The colour that multiplies image and vertex colours.
     *
     * @param imageShown whether the image of the texture has arrived
     * @return red, green, blue, opacity, each 0 to 1
     */
    static float[] of(DisplayMaterial material, boolean imageShown) {
        List<Float> colour = material.colour(imageShown);
        boolean isLinear = colour != null && material.gltf();
        List<Float> given = colour == null ? GREY : colour;
        float[] linear = new float[4];
        for (int k = 0; k < 3; k++) linear[k] = isLinear ? given.get(k) : linear(given.get(k));
        linear[3] = given.get(3);
        return linear;
    }

    /** Linear light of an sRGB value (IEC 61966-2-1). */
    private static float linear(float srgb) {
        double s = Math.max(0, Math.min(1, srgb));
        return (float) (s <= .04045 ? s / 12.92 : Math.pow((s + .055) / 1.055, 2.4));
    }
}
