package org.jsmesh.display;

import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Material;

/**
 * The look of materials with parameters: those of MTL, with its extension for physically based rendering, of Hoppe's .m
 * and of files that have colours of faces.
 */
final class MtlLook {
    /** Largest {@code Ns}. */
    private static final double SHARPEST = 1000;

    private static final int RGB = 3;
    private static final List<Float> GREY = List.of(.8f, .8f, .8f);
    private static final List<Float> WHITE = List.of(1f, 1f, 1f);

    private final Material material;
    private final Map<Slot, TextureUse> textures = new EnumMap<>(Slot.class);

    private MtlLook(Material material) {
        this.material = material;
    }

    static DisplayMaterial of(Material material, boolean vertexColours) {
        if (material == null) {
            List<Float> colour = vertexColours ? rgba(WHITE, 1) : null;
            return look(colour, -1, -1, null, Map.of());
        }
        return new MtlLook(material).look(vertexColours);
    }

    private static DisplayMaterial look(
            List<Float> colour, float metallic, float roughness, List<Float> emission, Map<Slot, TextureUse> textures) {
        return new DisplayMaterial(
                colour,
                false,
                metallic,
                roughness,
                DisplayMaterial.REFLECTANCE,
                null,
                emission,
                DisplayMaterial.Alpha.BY_IMAGE,
                DisplayMaterial.CUTOFF,
                true,
                false,
                textures);
    }

    private DisplayMaterial look(boolean vertexColours) {
        for (Material.TextureReference t : material.textures()) {
            switch (t.key()) {
                case "map_Kd" -> use(Slot.COLOUR, t, -1);
                case "map_Pm" -> use(Slot.METALLIC, t, 0);
                case "map_Pr" -> use(Slot.ROUGHNESS, t, 0);
                case "map_Ke" -> use(Slot.EMISSION, t, -1);
                case "map_d" -> use(Slot.OPACITY, t, -1);
                case "norm" -> use(Slot.NORMAL, t, -1);
                case "map_Bump", "map_bump", "bump" -> use(Slot.BUMP, t, 0);
                default -> {}
            }
        }
        TextureUse image = textures.get(Slot.COLOUR);
        TextureUse mask = textures.get(Slot.OPACITY);
        // The image's own opacity counts anyway.
        if (mask != null && image != null && mask.path().equals(image.path())) textures.remove(Slot.OPACITY);
        float metallic = one("Pm", textures.containsKey(Slot.METALLIC));
        float roughness = roughness();
        Map<Slot, TextureUse> uses = textures.isEmpty() ? Map.of() : uses();
        return look(colour(vertexColours, image != null), metallic, roughness, emission(), uses);
    }

    /** Not Map.copyOf: in the browser, such a copy cannot be asked for anything. */
    private Map<Slot, TextureUse> uses() {
        return Collections.unmodifiableMap(textures);
    }

    private void use(Slot slot, Material.TextureReference texture, int channel) {
        if (textures.containsKey(slot)) return;
        float[] scale = option(texture, "-s");
        float[] offset = option(texture, "-o");
        float[] strength = option(texture, "-bm");
        float su = scale.length > 0 ? scale[0] : 1;
        float sv = scale.length > 1 ? scale[1] : 1;
        float ou = offset.length > 0 ? offset[0] : 0;
        float ov = offset.length > 1 ? offset[1] : 0;
        boolean clamped = material.parameter(texture.key() + " -clamp on") != null;
        // MTL counts v from the lower edge.
        List<Float> transform = List.of(su, 0f, ou, 0f, -sv, rounded(1 - ov));
        textures.put(
                slot,
                new TextureUse(
                        texture.path(),
                        0,
                        clamped ? TextureUse.Sampler.CLAMPED : TextureUse.Sampler.USUAL,
                        transform,
                        strength.length > 0 ? strength[0] : 1,
                        channel));
    }

    private float[] option(Material.TextureReference texture, String name) {
        float[] values = material.parameter(texture.key() + ' ' + name);
        return values == null ? new float[0] : values;
    }

    /**
     * {@code Pr}, or what Blender makes of {@code Ns} and back, 1 − √(Ns/1000). A material that reflects nothing (black
     * {@code Ks}) is rough.
     */
    private float roughness() {
        float rough = one("Pr", textures.containsKey(Slot.ROUGHNESS));
        float[] sharp = material.parameter("Ns");
        if (rough >= 0 || sharp == null || sharp.length != 1) return rough;
        float[] reflected = material.parameter("Ks");
        if (reflected != null && isBlack(reflected)) return 1;
        double root = Math.sqrt(Math.max(0, Math.min(1, sharp[0] / SHARPEST)));
        return rounded(1 - root);
    }

    /** An image of the light stands for a black {@code Ke}, too. */
    private List<Float> emission() {
        boolean image = textures.containsKey(Slot.EMISSION);
        float[] light = material.parameter("Ke");
        if (light == null || light.length != RGB || isBlack(light)) return image ? WHITE : null;
        return List.of(Math.max(0, light[0]), Math.max(0, light[1]), Math.max(0, light[2]));
    }

    private List<Float> colour(boolean vertexColours, boolean image) {
        float[] rgb = material.parameter("Kd");
        if (rgb == null) rgb = material.parameter("rgb");
        boolean given = rgb != null;
        float opacity = opacity();
        if (!given && vertexColours) return rgba(WHITE, opacity);
        if (!given && !image && opacity >= 1) return null;
        // Many exporters leave the colour below an image black. Nobody is to see it before the image arrives.
        if (!given || rgb.length != RGB || image && isBlack(rgb)) return rgba(GREY, opacity);
        return List.of(rgb[0], rgb[1], rgb[2], opacity);
    }

    /**
     * {@code d}, or else 1 − {@code Tr}. Many programs write {@code Tr 1} alone and mean opaque, so nothing is ever
     * invisible by it.
     */
    private float opacity() {
        float[] opaque = material.parameter("d");
        if (opaque != null && opaque.length == 1) return Math.max(0, Math.min(1, opaque[0]));
        float[] transparent = material.parameter("Tr");
        boolean given = transparent != null && transparent.length == 1 && transparent[0] > 0 && transparent[0] < 1;
        return given ? rounded(1 - transparent[0]) : 1;
    }

    /** An image stands alone where there is no number to multiply it with. */
    private float one(String key, boolean image) {
        float[] value = material.parameter(key);
        if (value == null || value.length != 1) return image ? 1 : DisplayMaterial.UNKNOWN;
        return Math.max(0, Math.min(1, value[0]));
    }

    private static boolean isBlack(float[] rgb) {
        for (float part : rgb) if (part > 0) return false;
        return true;
    }

    private static List<Float> rgba(List<Float> rgb, float opacity) {
        return List.of(rgb.get(0), rgb.get(1), rgb.get(2), opacity);
    }

    /** Through bits: in JavaScript, nothing else rounds. */
    private static float rounded(double value) {
        return Float.intBitsToFloat(Float.floatToIntBits((float) value));
    }
}
