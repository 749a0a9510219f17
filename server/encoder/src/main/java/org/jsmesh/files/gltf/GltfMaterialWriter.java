package org.jsmesh.files.gltf;

import de.javagl.jgltf.impl.v2.GlTF;
import de.javagl.jgltf.impl.v2.Image;
import de.javagl.jgltf.impl.v2.MaterialNormalTextureInfo;
import de.javagl.jgltf.impl.v2.MaterialOcclusionTextureInfo;
import de.javagl.jgltf.impl.v2.MaterialPbrMetallicRoughness;
import de.javagl.jgltf.impl.v2.Texture;
import de.javagl.jgltf.impl.v2.TextureInfo;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;

/**
 * Writes materials and images. A definition with keys of other formats is translated for other programs. The extras
 * keep it word for word for {@link GltfMaterials}.
 */
final class GltfMaterialWriter {
    private static final Set<String> FACTORS = Set.of(
            "baseColorFactor", "metallicFactor", "roughnessFactor", "emissiveFactor", "alphaCutoff", "doubleSided");
    private static final Set<String> TEXTURES = Set.of(
            "baseColorTexture", "metallicRoughnessTexture", "normalTexture", "occlusionTexture", "emissiveTexture");

    private final Mesh mesh;
    private final GlTF gltf;
    private final GltfBuffer buffer;
    private final List<String> remarks;
    private final Map<String, Integer> textures = new HashMap<>();
    private boolean translated;

    GltfMaterialWriter(Mesh mesh, GlTF gltf, GltfBuffer buffer, List<String> remarks) {
        this.mesh = mesh;
        this.gltf = gltf;
        this.buffer = buffer;
        this.remarks = remarks;
    }

    void write() {
        boolean otherImages = false;
        for (org.jsmesh.mesh.Texture texture : mesh.textures()) {
            Image image = new Image();
            image.setName(texture.path());
            image.setBufferView(buffer.image(texture.bytes()));
            String type = mimeType(texture.bytes());
            otherImages |= type == null;
            image.setMimeType(type == null ? "application/octet-stream" : type);
            texture(texture.path(), image);
        }
        if (otherImages)
            remarks.add(
                    "glTF shows only PNG and JPEG images; others are in the file, but most programs do not show them.");
        for (Material material : mesh.materials())
            gltf.addMaterials(isNative(material) ? ownWords(material) : translation(material));
        if (translated)
            remarks.add("Materials of another format translated for glTF, their definitions kept in the extras.");
    }

    private static String mimeType(byte[] image) {
        if (image.length > 3 && image[0] == (byte) 0x89 && image[1] == 'P') return "image/png";
        return image.length > 3 && image[0] == (byte) 0xFF && image[1] == (byte) 0xD8 ? "image/jpeg" : null;
    }

    private int texture(String path, Image image) {
        int source = gltf.getImages() == null ? 0 : gltf.getImages().size();
        gltf.addImages(image);
        Texture texture = new Texture();
        texture.setSource(source);
        int index = gltf.getTextures() == null ? 0 : gltf.getTextures().size();
        gltf.addTextures(texture);
        textures.putIfAbsent(path, index);
        return index;
    }

    /** An image that was not found is named by its path. */
    private int textureOf(String path) {
        Integer known = textures.get(path);
        if (known != null) return known;
        Image image = new Image();
        image.setUri(URLEncoder.encode(path, StandardCharsets.UTF_8)
                .replace("+", "%20")
                .replace("%2F", "/"));
        return texture(path, image);
    }

    /** Whether {@link GltfMaterials} gets the same definition from glTF's own properties. */
    private static boolean isNative(Material material) {
        if (material.parameter("baseColorFactor") == null
                || material.parameter("metallicFactor") == null
                || material.parameter("roughnessFactor") == null) {
            return false;
        }
        for (Material.TextureReference reference : material.textures()) {
            if (!TEXTURES.contains(reference.key())) return false;
        }
        for (Material.Parameter p : material.parameters()) {
            boolean known = FACTORS.contains(p.key())
                    || p.key().matches("alphaMode (OPAQUE|MASK|BLEND)")
                    || p.key().matches("[A-Za-z]+Texture\\.(texCoord|scale|strength)");
            if (!known) return false;
        }
        return has(material, "baseColorFactor", 4) && has(material, "emissiveFactor", 3) && isScalar(material);
    }

    private static boolean has(Material material, String key, int count) {
        float[] values = material.parameter(key);
        if (values == null) return true;
        boolean valid = values.length == count;
        for (float v : values) valid &= v >= 0 && v <= 1;
        return valid;
    }

    private static boolean isScalar(Material material) {
        return material.parameters().stream()
                        .filter(p -> !p.key().equals("baseColorFactor")
                                && !p.key().equals("emissiveFactor")
                                && !p.key().startsWith("alphaMode"))
                        .allMatch(p -> p.values().length == 1)
                && has(material, "metallicFactor", 1)
                && has(material, "roughnessFactor", 1);
    }

    private de.javagl.jgltf.impl.v2.Material ownWords(Material material) {
        de.javagl.jgltf.impl.v2.Material out = new de.javagl.jgltf.impl.v2.Material();
        MaterialPbrMetallicRoughness pbr = new MaterialPbrMetallicRoughness();
        out.setName(material.name());
        out.setPbrMetallicRoughness(pbr);
        pbr.setBaseColorFactor(material.parameter("baseColorFactor"));
        pbr.setMetallicFactor(scalar(material, "metallicFactor"));
        pbr.setRoughnessFactor(scalar(material, "roughnessFactor"));
        if (material.parameter("emissiveFactor") != null) out.setEmissiveFactor(material.parameter("emissiveFactor"));
        if (material.parameter("alphaCutoff") != null) out.setAlphaCutoff(scalar(material, "alphaCutoff"));
        if (material.parameter("doubleSided") != null) out.setDoubleSided(true);
        for (Material.Parameter p : material.parameters()) {
            if (p.key().startsWith("alphaMode ")) out.setAlphaMode(p.key().substring("alphaMode ".length()));
        }
        for (Material.TextureReference reference : material.textures()) {
            switch (reference.key()) {
                case "baseColorTexture" -> pbr.setBaseColorTexture(info(new TextureInfo(), material, reference));
                case "metallicRoughnessTexture" ->
                    pbr.setMetallicRoughnessTexture(info(new TextureInfo(), material, reference));
                case "normalTexture" -> {
                    MaterialNormalTextureInfo info = info(new MaterialNormalTextureInfo(), material, reference);
                    info.setScale(scalar(material, "normalTexture.scale"));
                    out.setNormalTexture(info);
                }
                case "occlusionTexture" -> {
                    MaterialOcclusionTextureInfo info = info(new MaterialOcclusionTextureInfo(), material, reference);
                    info.setStrength(scalar(material, "occlusionTexture.strength"));
                    out.setOcclusionTexture(info);
                }
                default -> out.setEmissiveTexture(info(new TextureInfo(), material, reference));
            }
        }
        return out;
    }

    private static Float scalar(Material material, String key) {
        float[] values = material.parameter(key);
        return values == null ? null : Float.valueOf(values[0]);
    }

    private <T extends TextureInfo> T info(T info, Material material, Material.TextureReference reference) {
        info.setIndex(textureOf(reference.path()));
        Float set = scalar(material, reference.key() + ".texCoord");
        if (set != null) info.setTexCoord(set.intValue());
        return info;
    }

    /** glTF counts v from the top of an image, MTL from its bottom; a texture transform turns it over. */
    private de.javagl.jgltf.impl.v2.Material translation(Material material) {
        translated = true;
        de.javagl.jgltf.impl.v2.Material out = new de.javagl.jgltf.impl.v2.Material();
        MaterialPbrMetallicRoughness pbr = new MaterialPbrMetallicRoughness();
        out.setName(material.name());
        out.setPbrMetallicRoughness(pbr);
        float[] colour = material.displayColour();
        for (int i = 0; i < 4; i++) colour[i] = Math.min(1f, Math.max(0f, colour[i]));
        if (colour[3] < 1) out.setAlphaMode("BLEND");
        pbr.setBaseColorFactor(colour);
        pbr.setMetallicFactor(0f);
        String path = material.displayTexture();
        if (path != null) {
            TextureInfo info = new TextureInfo();
            info.setIndex(textureOf(path));
            boolean fromBelow = material.textures().stream()
                    .anyMatch(t -> t.key().equals("map_Kd") && t.path().equals(path));
            if (fromBelow) {
                info.addExtensions(
                        GltfWriter.TEXTURE_TRANSFORM,
                        ordered("offset", new float[] {0, 1}, "scale", new float[] {1, -1}));
                if (gltf.getExtensionsUsed() == null) gltf.addExtensionsUsed(GltfWriter.TEXTURE_TRANSFORM);
            }
            pbr.setBaseColorTexture(info);
        }
        out.setExtras(Map.of(GltfWriter.EXTRAS, definition(material)));
        return out;
    }

    private static Map<String, Object> definition(Material material) {
        List<List<Object>> parameters = new ArrayList<>();
        for (Material.Parameter p : material.parameters()) {
            List<Object> list = new ArrayList<>();
            list.add(p.key());
            for (float value : p.values()) list.add((double) value);
            parameters.add(list);
        }
        List<List<String>> references = new ArrayList<>();
        for (Material.TextureReference t : material.textures()) references.add(List.of(t.key(), t.path()));
        return ordered("parameters", parameters, "textures", references);
    }

    /** In this order, unlike the entries of Map.of, so that the same mesh gives the same bytes. */
    private static Map<String, Object> ordered(String first, Object firstValue, String second, Object secondValue) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put(first, firstValue);
        map.put(second, secondValue);
        return map;
    }
}
