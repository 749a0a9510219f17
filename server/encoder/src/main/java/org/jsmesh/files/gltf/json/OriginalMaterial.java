package org.jsmesh.files.gltf.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Material;

/** The definition of a material in another format, from the extras of its translation ({@link GltfExtras}). */
public final class OriginalMaterial {
    private static final int MOST_PARTS = 1 << 12;
    private static final int MOST_VALUES = 256;

    private final List<Material.Parameter> parameters = new ArrayList<>();
    private final List<Material.TextureReference> textures = new ArrayList<>();
    private final List<String> dropped = new ArrayList<>();

    /** @param jsm the object in the extras */
    public OriginalMaterial(JsonNode jsm) {
        for (JsonNode given : jsm.path(GltfExtras.PARAMETERS)) parameter(given);
        for (JsonNode given : jsm.path(GltfExtras.TEXTURES)) texture(given);
    }

    private void parameter(JsonNode given) {
        String key = given.path(0).asText();
        float[] values = new float[Math.max(0, given.size() - 1)];
        boolean fits = fits(given, key) && values.length <= MOST_VALUES && parameters.size() < MOST_PARTS;
        for (int i = 0; i < values.length && fits; i++) {
            values[i] = (float) given.get(i + 1).asDouble();
            fits = given.get(i + 1).isNumber() && Float.isFinite(values[i]);
        }
        if (fits) parameters.add(new Material.Parameter(key, values));
        else dropped.add(key);
    }

    private void texture(JsonNode given) {
        String key = given.path(0).asText();
        String path = given.path(1).asText();
        boolean fits = fits(given, key) && fits(given, path) && textures.size() < MOST_PARTS;
        if (fits) textures.add(new Material.TextureReference(key, path));
        else dropped.add(key);
    }

    private static boolean fits(JsonNode given, String text) {
        return given.isArray() && text.getBytes(StandardCharsets.UTF_8).length <= LongNames.MOST_BYTES;
    }

    public Material material(String name) {
        return new Material(name, parameters, textures, "");
    }

    /** Keys of what is no parameter and no texture, or more than an archive holds. */
    public List<String> dropped() {
        return dropped;
    }
}
