package org.jsmesh.files.gltf.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Set;

/**
 * Which parts of a material name a texture. A texture info is an object under a key that ends in {@code Texture}, or is
 * {@code texture}, at any depth of the material, but not within extras. Its {@code index} is a number in a file of
 * glTF, and the texture itself in a definition of jSM.
 */
public final class TextureInfos {
    /** They give a texture another image. Their property {@code source} is the number of it. */
    private static final Set<String> WITH_SOURCE = Set.of(
            "EXT_texture_avif", "EXT_texture_webp", "GOOGLE_texture_basis", "KHR_texture_basisu", "MSFT_texture_dds");

    private TextureInfos() {}

    /** Whether a value is a texture info when it has an index. */
    public static boolean isSlot(String key, JsonNode value) {
        return (key.endsWith("Texture") || key.equals("texture")) && value.isObject();
    }

    /** Whether an extension of a texture names an image. */
    public static boolean hasSource(String extension) {
        return WITH_SOURCE.contains(extension);
    }
}
