package org.jsmesh.poster;

import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.RenderMesh;
import org.jsmesh.display.Slot;
import org.jsmesh.display.TextureUse;
import org.jsmesh.studio.Lighting;
import org.jsmesh.studio.LinearColour;
import org.jsmesh.studio.Opacity;

/** A material as it is drawn: numbers in linear light, and the images that are there. */
final class Surface {
    private static final int NEAREST = 9728;

    final float[] base;
    final float[] emission;
    final double metallic;
    final double roughness;
    final double[] reflectance = new double[4];
    final double coat;
    final double coatRoughness;
    final boolean isUnlit;
    final boolean isBlended;
    final boolean isDoubleSided;
    /** Whether the alpha of the colour's image counts. */
    final boolean hasImageOpacity;

    /** Opacity below which the surface is not there; −1 for never. */
    final double cutoff;

    private final Use[] uses = new Use[Slot.values().length];

    /** How an image is used: see {@link TextureUse}. */
    record Use(Image image, int set, float[] transform, double factor, int channel, Image.Wrapping wrapping) {
        /** One of the numbers of a pixel. */
        double one(double[] rgba) {
            return rgba[Math.max(0, channel)];
        }
    }

    Surface(DisplayMaterial material, RenderMesh mesh, Images images) {
        for (Slot slot : Slot.values())
            uses[slot.ordinal()] = use(slot, material.textures().get(slot), mesh, images);
        Use colour = use(Slot.COLOUR);
        base = LinearColour.of(material, colour != null);
        emission = LinearColour.emission(material);
        metallic = Math.max(0, material.metallic());
        roughness = material.roughness() < 0 ? Lighting.PLAIN_ROUGHNESS : material.roughness();
        for (int k = 0; k < 4; k++) reflectance[k] = material.reflectance().get(k);
        coat = material.coat() == null ? 0 : material.coat().get(0);
        coatRoughness = material.coat() == null ? 0 : material.coat().get(1);
        isUnlit = material.unlit();
        isDoubleSided = material.doubleSided();
        boolean byImage = material.alpha() == DisplayMaterial.Alpha.BY_IMAGE;
        Opacity ofColour = byImage && colour != null ? images.opacity(colour.image) : Opacity.OPAQUE;
        Use mask = use(Slot.OPACITY);
        Opacity ofMask = byImage && mask != null ? images.opacity(mask.image) : Opacity.OPAQUE;
        hasImageOpacity = !byImage || ofColour != Opacity.OPAQUE;
        isBlended = !material.isOpaque() || ofColour == Opacity.GLASS || ofMask == Opacity.GLASS;
        boolean hasHoles = ofColour == Opacity.HOLES || ofMask == Opacity.HOLES;
        if (material.alpha() == DisplayMaterial.Alpha.MASK) cutoff = material.cutoff();
        else cutoff = hasHoles ? material.cutoff() * base[3] : -1;
    }

    /** Whether nothing behind the surface is seen through it. */
    boolean isSolid() {
        return !isBlended && cutoff <= 0;
    }

    /** The image in a slot, or null when there is none. */
    Use use(Slot slot) {
        return uses[slot.ordinal()];
    }

    private static Use use(Slot slot, TextureUse use, RenderMesh mesh, Images images) {
        if (use == null || use.set() >= mesh.textureCoordinates().length) return null;
        if (mesh.textureCoordinates()[use.set()].length == 0) return null;
        Image image = images.of(slot, use.path());
        if (image == null) return null;
        float[] transform = new float[6];
        for (int k = 0; k < transform.length; k++)
            transform[k] = use.transform().get(k);
        TextureUse.Sampler sampler = use.sampler();
        Image.Wrapping wrapping = new Image.Wrapping(sampler.wrapU(), sampler.wrapV(), sampler.magFilter() == NEAREST);
        return new Use(image, use.set(), transform, use.factor(), slot == Slot.OPACITY ? 3 : use.channel(), wrapping);
    }
}
