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
 * @param textureFromTop whether v = 0 is the top row of the image, as in glTF, or the bottom row, as in MTL
 */
record Surface(float red, float green, float blue, float opacity, String texture, boolean textureFromTop) {
    private static final Surface GREY = new Surface(linear(.8f), linear(.8f), linear(.8f), 1, null, false);
    private static final Surface WHITE = new Surface(1, 1, 1, 1, null, false);

    /**
     * @param material of the faces, or null
     * @param vertexColours whether the mesh has colours of its own, which a face without material shows unchanged
     */
    static Surface of(Material material, boolean vertexColours) {
        if (material == null) return vertexColours ? WHITE : GREY;
        float[] c = material.displayColour();
        String texture = material.displayTexture();
        boolean fromTop = material.textures().stream().anyMatch(t -> t.key().equals("baseColorTexture"));
        // glTF gives linear factors, everything else the numbers of a screen.
        if (material.parameter("baseColorFactor") != null) return new Surface(c[0], c[1], c[2], c[3], texture, fromTop);
        // Many exporters leave the colour below a texture black or grey; the image is meant to be seen as it is.
        boolean unpainted = material.parameter("Kd") == null && material.parameter("rgb") == null;
        if (texture != null || unpainted && vertexColours) return new Surface(1, 1, 1, c[3], texture, fromTop);
        return new Surface(linear(c[0]), linear(c[1]), linear(c[2]), c[3], null, fromTop);
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
