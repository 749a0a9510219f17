package org.jsmesh.files.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import de.javagl.jgltf.impl.v2.MaterialNormalTextureInfo;
import de.javagl.jgltf.impl.v2.MaterialOcclusionTextureInfo;
import de.javagl.jgltf.impl.v2.MaterialPbrMetallicRoughness;
import de.javagl.jgltf.impl.v2.TextureInfo;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Texture;
import org.jsmesh.mesh.io.MeshAssembler;

/**
 * The materials that faces use, with glTF's own keys. Base colour, metallic and roughness factors are always there,
 * others where the file gives them. A definition that {@link GltfWriter} put into the extras of a material takes
 * precedence over its translation.
 */
final class GltfMaterials {
    private static final float[] WHITE = {1, 1, 1, 1};

    private final GltfDocument document;
    private final List<Note> notes;
    private final GltfImages images;
    private int imageless;
    private String firstImageless;

    GltfMaterials(GltfDocument document, List<Note> notes) {
        this.document = document;
        this.notes = notes;
        images = new GltfImages(document);
    }

    /** Materials and textures, numbered by first use. */
    MeshAssembler addTo(MeshAssembler assembler, int[] faceMaterials) throws IOException {
        Map<Integer, Integer> ids = new LinkedHashMap<>();
        List<Material> materials = new ArrayList<>();
        int[] faces = new int[faceMaterials.length];
        Arrays.fill(faces, -1);
        for (int f = 0; f < faces.length; f++) {
            int gltfId = faceMaterials[f];
            if (gltfId == -1) continue;
            Integer id = ids.get(gltfId);
            if (id == null) {
                id = materials.size();
                ids.put(gltfId, id);
                materials.add(material(gltfId));
            }
            faces[f] = id;
        }
        return assembler.materials(faces, materials, textures(materials));
    }

    private List<Texture> textures(List<Material> materials) throws IOException {
        Set<String> paths = new LinkedHashSet<>();
        for (Material material : materials) material.textures().forEach(t -> paths.add(t.path()));
        List<Texture> textures = new ArrayList<>();
        List<String> missing = new ArrayList<>();
        for (String path : paths) {
            Optional<byte[]> bytes = images.bytes(path);
            bytes.ifPresentOrElse(b -> textures.add(new Texture(path, b)), () -> missing.add(path));
        }
        if (imageless > 0) {
            String text = imageless == 1
                    ? "1 texture without an image in a known format left out."
                    : imageless + " textures without an image in a known format left out.";
            notes.add(Note.dropped(text, imageless, firstImageless));
        }
        if (!missing.isEmpty())
            notes.add(GltfNames.note(Note.Kind.DROPPED, "Textures not found, their references kept", missing));
        return textures;
    }

    private Material material(int id) throws IOException {
        de.javagl.jgltf.impl.v2.Material given = document.get(document.gltf().getMaterials(), id, "material");
        JsonNode original =
                document.root().path("materials").path(id).path("extras").path(GltfWriter.EXTRAS);
        String name = given.getName() == null ? "material" + id : given.getName();
        if (original.isObject()) return original(name, original);
        List<Material.Parameter> parameters = new ArrayList<>();
        List<Material.TextureReference> textures = new ArrayList<>();
        MaterialPbrMetallicRoughness pbr = given.getPbrMetallicRoughness();
        if (pbr == null) pbr = new MaterialPbrMetallicRoughness();
        add(parameters, "baseColorFactor", pbr.getBaseColorFactor() == null ? WHITE : pbr.getBaseColorFactor());
        add(parameters, "metallicFactor", pbr.getMetallicFactor() == null ? 1f : pbr.getMetallicFactor());
        add(parameters, "roughnessFactor", pbr.getRoughnessFactor() == null ? 1f : pbr.getRoughnessFactor());
        if (given.getEmissiveFactor() != null) add(parameters, "emissiveFactor", given.getEmissiveFactor());
        if (given.getAlphaMode() != null) parameters.add(new Material.Parameter("alphaMode " + given.getAlphaMode()));
        if (given.getAlphaCutoff() != null) add(parameters, "alphaCutoff", given.getAlphaCutoff());
        if (Boolean.TRUE.equals(given.isDoubleSided())) add(parameters, "doubleSided", 1f);
        texture(parameters, textures, "baseColorTexture", pbr.getBaseColorTexture());
        texture(parameters, textures, "metallicRoughnessTexture", pbr.getMetallicRoughnessTexture());
        MaterialNormalTextureInfo normal = given.getNormalTexture();
        texture(parameters, textures, "normalTexture", normal);
        if (normal != null && normal.getScale() != null) add(parameters, "normalTexture.scale", normal.getScale());
        MaterialOcclusionTextureInfo occlusion = given.getOcclusionTexture();
        texture(parameters, textures, "occlusionTexture", occlusion);
        if (occlusion != null && occlusion.getStrength() != null)
            add(parameters, "occlusionTexture.strength", occlusion.getStrength());
        texture(parameters, textures, "emissiveTexture", given.getEmissiveTexture());
        return new Material(name, parameters, textures);
    }

    private static void add(List<Material.Parameter> parameters, String key, float... values) {
        parameters.add(new Material.Parameter(key, values));
    }

    private void texture(
            List<Material.Parameter> parameters, List<Material.TextureReference> textures, String key, TextureInfo info)
            throws IOException {
        if (info == null) return;
        Integer source = document.get(document.gltf().getTextures(), info.getIndex(), "texture")
                .getSource();
        if (source == null) {
            if (imageless++ == 0) firstImageless = key;
            return;
        }
        textures.add(new Material.TextureReference(key, images.path(source)));
        if (info.getTexCoord() != null && info.getTexCoord() != 0)
            add(parameters, key + ".texCoord", info.getTexCoord());
    }

    private Material original(String name, JsonNode definition) {
        List<Material.Parameter> parameters = new ArrayList<>();
        for (JsonNode parameter : definition.path("parameters")) {
            float[] values = new float[Math.max(0, parameter.size() - 1)];
            for (int i = 0; i < values.length; i++)
                values[i] = (float) parameter.get(i + 1).asDouble();
            parameters.add(new Material.Parameter(parameter.path(0).asText(), values));
        }
        List<Material.TextureReference> textures = new ArrayList<>();
        for (JsonNode texture : definition.path("textures")) {
            textures.add(new Material.TextureReference(
                    texture.path(0).asText(), texture.path(1).asText()));
        }
        return new Material(name, parameters, textures);
    }
}
