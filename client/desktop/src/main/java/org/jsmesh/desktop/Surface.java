package org.jsmesh.desktop;

import org.jsmesh.mesh.Material;

/**
 * How a material is drawn.
 *
 * @param red linear light, 0 to 1
 * @param green linear light, 0 to 1
 * @param blue linear light, 0 to 1
 * @param opacity 1 hides what is behind
 * @param texture path of the colour texture, or null
 * @param isGltf glTF multiplies image and colour, and v = 0 is the top row of the image; elsewhere the image hides the
 *     colour, and v = 0 is the bottom row
 */
record Surface(float red, float green, float blue, float opacity, String texture, boolean isGltf) {
    private static final float LIGHT_GREY = linear(.8f);
    private static final Surface GREY = new Surface(LIGHT_GREY, LIGHT_GREY, LIGHT_GREY, 1, null, false);
    private static final Surface WHITE = new Surface(1, 1, 1, 1, null, false);

    /**
     * @param material of the faces, or null
     * @param vertexColours whether the mesh has colours of its own, which a face without material shows unchanged
     */
    static Surface of(Material material, boolean vertexColours) {
        if (material == null) return vertexColours ? WHITE : GREY;
        float[] c = material.displayColour();
        String texture = material.displayTexture();
        boolean gltf = material.parameter("baseColorFactor") != null
                || material.textures().stream().anyMatch(t -> t.key().equals("baseColorTexture"));
        // glTF gives linear factors, everything else the numbers of a screen.
        if (material.parameter("baseColorFactor") != null) return new Surface(c[0], c[1], c[2], c[3], texture, true);
        boolean unpainted = material.parameter("Kd") == null && material.parameter("rgb") == null;
        if (unpainted && (vertexColours || gltf)) return new Surface(1, 1, 1, c[3], texture, gltf);
        return new Surface(linear(c[0]), linear(c[1]), linear(c[2]), c[3], texture, gltf);
    }

    /** The colour that multiplies image and vertex colours, with opacity. */
    float[] factor(boolean imageShown) {
        // Many exporters leave the colour below an image black or grey; the image is meant to be seen as it is.
        if (imageShown && !isGltf) return new float[] {1, 1, 1, opacity};
        // Before its image arrives, such a black is no colour of the model either.
        boolean black = texture != null && red + green + blue == 0;
        return black
                ? new float[] {LIGHT_GREY, LIGHT_GREY, LIGHT_GREY, opacity}
                : new float[] {red, green, blue, opacity};
    }

    boolean isOpaque() {
        return opacity >= 1;
    }

    /** Linear light of an sRGB value (IEC 61966-2-1). */
    static float linear(float srgb) {
        double s = Math.max(0, Math.min(1, srgb));
        return (float) (s <= .04045 ? s / 12.92 : Math.pow((s + .055) / 1.055, 2.4));
    }
}
