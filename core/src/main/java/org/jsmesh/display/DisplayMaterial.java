package org.jsmesh.display;

import java.util.List;
import org.jsmesh.mesh.Material;

/**
 * How a material looks. Equal ones can be drawn at once.
 *
 * @param colour red, green, blue, opacity, each 0 to 1, to multiply vertex colours with; null for the colour that the
 *     viewer gives to models without any
 * @param texture path of the colour texture, or null
 * @param gltf true when it comes from glTF: the colour is in linear light and multiplies the texture, and v = 0 is the
 *     top row of the image. Otherwise the colour is sRGB and the texture hides it, and v = 0 is the bottom row
 * @param metallic 0 to 1, or −1 when the material does not say
 * @param roughness 0 to 1, or −1 when the material does not say
 */
public record DisplayMaterial(List<Float> colour, String texture, boolean gltf, float metallic, float roughness) {
    private static final float UNKNOWN = -1;
    private static final float[] WHITE = {1, 1, 1, 1};
    private static final float[] GREY = {.8f, .8f, .8f, 1};

    /** That of faces without a material: vertex colours show unchanged. */
    static DisplayMaterial ofNone(boolean vertexColours) {
        return new DisplayMaterial(vertexColours ? rgba(WHITE, 1) : null, null, false, UNKNOWN, UNKNOWN);
    }

    static DisplayMaterial of(Material material, boolean vertexColours) {
        String texture = material.displayTexture();
        boolean gltf = isGltf(material);
        return new DisplayMaterial(
                colour(material, texture, gltf, vertexColours),
                texture,
                gltf,
                one(material, "metallicFactor"),
                one(material, "roughnessFactor"));
    }

    private static List<Float> colour(Material material, String texture, boolean gltf, boolean vertexColours) {
        float[] c = material.displayColour();
        if (!hasColour(material)) {
            if (vertexColours || gltf) return rgba(WHITE, c[3]);
            return texture == null && c[3] >= 1 ? null : rgba(GREY, c[3]);
        }
        // Many exporters leave the colour below an image black. Nobody is to see it before the image arrives.
        boolean hidden = texture != null && !gltf && c[0] == 0 && c[1] == 0 && c[2] == 0;
        return rgba(hidden ? GREY : c, c[3]);
    }

    private static List<Float> rgba(float[] rgb, float opacity) {
        return List.of(rgb[0], rgb[1], rgb[2], opacity);
    }

    /**
     * The colour to draw with, in the colour space of {@link #colour}.
     *
     * @param imageShown whether the image of the texture has arrived
     * @return red, green, blue, opacity, or null for the viewer's own colour
     */
    public List<Float> colour(boolean imageShown) {
        return imageShown && !gltf ? rgba(WHITE, colour.get(3)) : colour;
    }

    /** {@return whether it hides what is behind it: its opacity is 1, or it has the viewer's own colour} */
    public boolean isOpaque() {
        return colour == null || colour.get(3) >= 1;
    }

    private static boolean hasColour(Material material) {
        return material.parameter("baseColorFactor") != null
                || material.parameter("Kd") != null
                || material.parameter("rgb") != null;
    }

    private static boolean isGltf(Material material) {
        if (material.parameter("baseColorFactor") != null) return true;
        return material.textures().stream().anyMatch(t -> t.key().equals("baseColorTexture"));
    }

    private static float one(Material material, String key) {
        float[] value = material.parameter(key);
        return value == null || value.length != 1 ? UNKNOWN : value[0];
    }
}
