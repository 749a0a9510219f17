package org.jsmesh.display;

import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Material;

/**
 * How a material looks, for materials of all formats.
 *
 * @param colour red, green, blue, opacity, each 0 to 1, to multiply vertex colours with; null for the colour that the
 *     viewer gives to models without any
 * @param linear true when it comes from glTF: colour and emission are in linear light, and the colour multiplies its
 *     image. Otherwise they are sRGB, and the image hides the colour
 * @param metallic 0 to 1, or −1 when the material does not say; multiplies its image
 * @param roughness 0 to 1, or −1 when the material does not say; multiplies its image
 * @param reflectance what a surface which is no metal reflects: of red, green and blue light from straight ahead, each
 *     .04 for most surfaces, and of all light from the side, 1 for most
 * @param coat clear coat over the surface: its strength and its roughness; null for none
 * @param emission red, green, blue of light that the surface sends out, beyond 1 where it is strong; null for none
 * @param alpha what opacity means
 * @param cutoff opacity from which on a surface with holes is there
 * @param doubleSided whether the back of faces is seen
 * @param unlit whether the colour is shown as it is, whatever the light
 * @param textures how each slot that is drawn uses an image
 */
public record DisplayMaterial(
        List<Float> colour,
        boolean linear,
        float metallic,
        float roughness,
        List<Float> reflectance,
        List<Float> coat,
        List<Float> emission,
        Alpha alpha,
        float cutoff,
        boolean doubleSided,
        boolean unlit,
        Map<Slot, TextureUse> textures) {
    /** What opacity means. */
    public enum Alpha {
        /** Nothing. */
        OPAQUE,
        /** The surface is there from the cutoff on. */
        MASK,
        /** What is behind the surface shines through. */
        BLEND,
        /** What the images say: holes where they are either opaque or unseen, else blended. */
        BY_IMAGE
    }

    static final float UNKNOWN = -1;
    static final List<Float> REFLECTANCE = List.of(.04f, .04f, .04f, 1f);
    static final float CUTOFF = .5f;

    /**
     * How a material of a model looks.
     *
     * @param material of any format; null for faces without one, which show vertex colours unchanged
     * @param vertexColours whether the model has colours per wedge, which a material without colour shows unchanged
     * @return its look
     */
    public static DisplayMaterial of(Material material, boolean vertexColours) {
        return material != null && material.isGltf() ? GltfLook.of(material) : ofOther(material, vertexColours);
    }

    /**
     * The same for materials of other formats than glTF.
     *
     * @param material one that is not of glTF; null for faces without one
     * @param vertexColours as in {@link #of}
     * @return its look
     */
    public static DisplayMaterial ofOther(Material material, boolean vertexColours) {
        return MtlLook.of(material, vertexColours);
    }

    /**
     * The path of the image in a slot.
     *
     * @param slot which one
     * @return its path, or null when there is none
     */
    public String image(Slot slot) {
        TextureUse use = textures.get(slot);
        return use == null ? null : use.path();
    }

    /**
     * The colour to draw with, linear or not as {@link #linear} says.
     *
     * @param imageShown whether the image of the colour has arrived
     * @return red, green, blue, opacity, or null for the viewer's own colour
     */
    public List<Float> colour(boolean imageShown) {
        return imageShown && !linear ? List.of(1f, 1f, 1f, colour.get(3)) : colour;
    }

    /**
     * The colour for programs that draw no images.
     *
     * @return red, green, blue as sRGB, opacity, each 0 to 1; light grey when the material has none
     */
    public float[] plain() {
        float[] plain = {.8f, .8f, .8f, 1};
        for (int k = 0; k < 4 && colour != null; k++)
            plain[k] = linear && k < 3 ? LinearLight.toScreen(colour.get(k)) : colour.get(k);
        if (linear && alpha == Alpha.OPAQUE) plain[3] = 1;
        return plain;
    }

    /** {@return whether opacity of the material alone hides what is behind it: images may say otherwise} */
    public boolean isOpaque() {
        return alpha == Alpha.BY_IMAGE ? colour == null || colour.get(3) >= 1 : alpha != Alpha.BLEND;
    }
}
