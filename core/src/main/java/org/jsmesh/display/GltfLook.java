package org.jsmesh.display;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.Material;

/**
 * The look of a material of glTF 2.0, of its extensions KHR_materials_unlit, emissive_strength, ior, specular,
 * clearcoat and pbrSpecularGlossiness, and of KHR_texture_transform. What is missing or of another type has the value
 * that the specification gives it.
 */
final class GltfLook {
    private static final String GLOSSY = "KHR_materials_pbrSpecularGlossiness";
    private static final int RGB = 3;

    private final Material material;
    private final Map<String, Object> json;
    private final Map<String, Object> extensions;
    private final Map<Slot, TextureUse> textures = new EnumMap<>(Slot.class);

    private GltfLook(Material material) {
        this.material = material;
        json = JsonText.object(material.gltf());
        extensions = object(json, "extensions");
    }

    static DisplayMaterial of(Material material) {
        return new GltfLook(material).look();
    }

    private DisplayMaterial look() {
        Map<String, Object> pbr = object(json, "pbrMetallicRoughness");
        Map<String, Object> glossy = object(extensions, GLOSSY);
        // Where a file says both, most viewers know the core part alone.
        boolean isGlossy = extensions.get(GLOSSY) instanceof Map && !json.containsKey("pbrMetallicRoughness");
        List<Float> colour =
                isGlossy ? numbers(glossy, "diffuseFactor", 1, 4, 0, 1) : numbers(pbr, "baseColorFactor", 1, 4, 0, 1);
        float metallic = isGlossy ? 0 : number(pbr, "metallicFactor", 1, 0, 1);
        float roughness =
                isGlossy ? 1 - number(glossy, "glossinessFactor", 1, 0, 1) : number(pbr, "roughnessFactor", 1, 0, 1);
        if (isGlossy) {
            use(Slot.COLOUR, object(glossy, "diffuseTexture"), "", -1);
        } else {
            use(Slot.COLOUR, object(pbr, "baseColorTexture"), "", -1);
            use(Slot.METALLIC, object(pbr, "metallicRoughnessTexture"), "", 2);
            use(Slot.ROUGHNESS, object(pbr, "metallicRoughnessTexture"), "", 1);
        }
        use(Slot.NORMAL, object(json, "normalTexture"), "scale", -1);
        use(Slot.OCCLUSION, object(json, "occlusionTexture"), "strength", 0);
        use(Slot.EMISSION, object(json, "emissiveTexture"), "", -1);
        return new DisplayMaterial(
                colour,
                true,
                metallic,
                roughness,
                isGlossy ? reflectance(glossy) : reflectance(),
                coat(),
                emission(),
                alpha(),
                number(json, "alphaCutoff", DisplayMaterial.CUTOFF, 0, Float.MAX_VALUE),
                Boolean.TRUE.equals(json.get("doubleSided")),
                extensions.containsKey("KHR_materials_unlit"),
                Map.copyOf(textures));
    }

    /** Of a surface that is given by what it reflects. */
    private static List<Float> reflectance(Map<String, Object> glossy) {
        List<Float> colour = numbers(glossy, "specularFactor", 1, RGB, 0, 1);
        return List.of(colour.get(0), colour.get(1), colour.get(2), 1f);
    }

    private List<Float> reflectance() {
        float ior = number(object(extensions, "KHR_materials_ior"), "ior", 1.5f, 0, Float.MAX_VALUE);
        Map<String, Object> extension = object(extensions, "KHR_materials_specular");
        float specular = number(extension, "specularFactor", 1, 0, 1);
        List<Float> colour = numbers(extension, "specularColorFactor", 1, RGB, 0, Float.MAX_VALUE);
        // An index of 0 stands for an infinite one.
        float root = ior < 1 ? ior == 0 ? 1 : 0 : (ior - 1) / (ior + 1);
        List<Float> all = new ArrayList<>();
        for (float part : colour) all.add(Math.min(1, root * root * part) * specular);
        all.add(specular);
        return List.copyOf(all);
    }

    private List<Float> coat() {
        Map<String, Object> coat = object(extensions, "KHR_materials_clearcoat");
        float strength = number(coat, "clearcoatFactor", 0, 0, 1);
        return strength == 0 ? null : List.of(strength, number(coat, "clearcoatRoughnessFactor", 0, 0, 1));
    }

    private List<Float> emission() {
        List<Float> light = numbers(json, "emissiveFactor", 0, 3, 0, Float.MAX_VALUE);
        float strength = number(
                object(extensions, "KHR_materials_emissive_strength"), "emissiveStrength", 1, 0, Float.MAX_VALUE);
        List<Float> all = new ArrayList<>();
        boolean black = true;
        for (float part : light) {
            float strong = Math.min(Float.MAX_VALUE, part * strength);
            black &= strong == 0;
            all.add(strong);
        }
        return black ? null : List.copyOf(all);
    }

    private DisplayMaterial.Alpha alpha() {
        if ("MASK".equals(json.get("alphaMode"))) return DisplayMaterial.Alpha.MASK;
        return "BLEND".equals(json.get("alphaMode")) ? DisplayMaterial.Alpha.BLEND : DisplayMaterial.Alpha.OPAQUE;
    }

    /** @param factor the name of the number that says how strong the image is; empty for none */
    private void use(Slot slot, Map<String, Object> info, String factor, int channel) {
        Map<String, Object> texture = object(info, "index");
        int source = source(texture);
        if (source < 0) return;
        Map<String, Object> transform = object(object(info, "extensions"), "KHR_texture_transform");
        float set = number(info, "texCoord", 0, 0, Integer.MAX_VALUE);
        set = number(transform, "texCoord", set, 0, Integer.MAX_VALUE);
        if (set >= RenderMesh.SETS) return; // as on the page
        float strength = factor.isEmpty() ? 1 : number(info, factor, 1, -Float.MAX_VALUE, Float.MAX_VALUE);
        if (slot == Slot.OCCLUSION) strength = Math.max(0, Math.min(1, strength));
        textures.put(
                slot,
                new TextureUse(
                        material.textures().get(source).path(),
                        (int) set,
                        sampler(object(texture, "sampler")),
                        transform(transform),
                        strength,
                        channel));
    }

    /** Of the image that every viewer knows, else of one that an extension names. */
    private int source(Map<String, Object> texture) {
        int source = (int) number(texture, "source", -1, -1, Integer.MAX_VALUE);
        for (Object extension : object(texture, "extensions").values())
            if (source < 0 && extension instanceof Map<?, ?> map && map.get("source") instanceof Double d)
                source = (int) Math.max(-1, d);
        return source < material.textures().size() ? source : -1;
    }

    private static TextureUse.Sampler sampler(Map<String, Object> json) {
        TextureUse.Sampler usual = TextureUse.Sampler.USUAL;
        return new TextureUse.Sampler(
                (int) number(json, "magFilter", usual.magFilter(), 0, Integer.MAX_VALUE),
                (int) number(json, "minFilter", usual.minFilter(), 0, Integer.MAX_VALUE),
                (int) number(json, "wrapS", usual.wrapU(), 0, Integer.MAX_VALUE),
                (int) number(json, "wrapT", usual.wrapV(), 0, Integer.MAX_VALUE));
    }

    /** Offset, rotation and scale, as the extension multiplies them. */
    private static List<Float> transform(Map<String, Object> json) {
        if (json.isEmpty()) return TextureUse.IDENTITY;
        float most = Float.MAX_VALUE;
        List<Float> offset = numbers(json, "offset", 0, 2, -most, most);
        List<Float> scale = numbers(json, "scale", 1, 2, -most, most);
        double angle = number(json, "rotation", 0, -most, most);
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        return List.of(
                (float) (cos * scale.get(0)),
                (float) (sin * scale.get(1)),
                offset.get(0),
                (float) (-sin * scale.get(0)),
                (float) (cos * scale.get(1)),
                offset.get(1));
    }

    @SuppressWarnings("unchecked")
    private static Map<String, Object> object(Map<String, Object> parent, String key) {
        return parent.get(key) instanceof Map<?, ?> map ? (Map<String, Object>) map : Map.of();
    }

    private static float number(Map<String, Object> parent, String key, float otherwise, float least, float most) {
        return number(parent.get(key), otherwise, least, most);
    }

    private static float number(Object value, float otherwise, float least, float most) {
        return value instanceof Double d && !d.isNaN() ? (float) Math.max(least, Math.min(most, d)) : otherwise;
    }

    private static List<Float> numbers(
            Map<String, Object> parent, String key, float otherwise, int count, float least, float most) {
        List<Float> numbers = new ArrayList<>();
        boolean given = parent.get(key) instanceof List<?> list && list.size() == count;
        for (int i = 0; i < count; i++) {
            Object value = given ? ((List<?>) parent.get(key)).get(i) : null;
            numbers.add(number(value, otherwise, least, most));
        }
        return List.copyOf(numbers);
    }
}
