package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jsmesh.files.gltf.json.ImageType;
import org.jsmesh.files.gltf.json.TextureInfos;
import org.jsmesh.mesh.Material;

/**
 * The textures and samplers of a file, each distinct one once. Two whose texts differ, if only in the order of keys,
 * are distinct, so that each material comes back word for word.
 */
final class TextureList {
    private final ImageList images;
    private final ExtensionNames extensions;
    private final Map<String, JsonNode> textures = new LinkedHashMap<>();
    private final Map<String, JsonNode> samplers = new LinkedHashMap<>();
    private final Map<JsonNode, Integer> numbers = new IdentityHashMap<>();

    TextureList(ImageList images, ExtensionNames extensions) {
        this.images = images;
        this.extensions = extensions;
    }

    /**
     * The number of a texture.
     *
     * @param texture as the definition of a material has it: with its sampler, and with positions in the textures of
     *     the material as sources
     */
    int number(ObjectNode texture, Material material) {
        ObjectNode lifted = texture.deepCopy();
        if (lifted.get("sampler") instanceof ObjectNode sampler) lifted.put("sampler", number(samplers, sampler));
        boolean plain = source(lifted, material);
        for (Map.Entry<String, JsonNode> extension : lifted.path("extensions").properties()) {
            if (!TextureInfos.hasSource(extension.getKey())) continue;
            if (extension.getValue() instanceof ObjectNode object && source(object, material) && !plain)
                extensions.require(extension.getKey());
        }
        extensions.use(lifted);
        return number(textures, lifted);
    }

    /** The number of a texture with an image that is in the file, or −1 when glTF has no such images. */
    int number(String path, JsonNode sampler) {
        byte[] bytes = images.bytes(path);
        ImageType type = bytes == null ? ImageType.OTHER : ImageType.of(bytes);
        if (!type.isKnown()) return -1;
        ObjectNode texture = JsonNodeFactory.instance.objectNode();
        if (!sampler.isEmpty()) texture.put("sampler", number(samplers, sampler));
        if (type.extension().isEmpty()) {
            texture.put("source", images.number(path));
        } else {
            texture.putObject("extensions").putObject(type.extension()).put("source", images.number(path));
            extensions.use(texture);
            extensions.require(type.extension());
        }
        return number(textures, texture);
    }

    /** Puts the number of the image in the place of a position; says whether there is one. */
    private boolean source(ObjectNode holder, Material material) {
        JsonNode given = holder.path("source");
        if (!given.isNumber()) return false;
        int position = given.intValue();
        if (position >= 0 && position < material.textures().size()) {
            holder.put("source", images.number(material.textures().get(position).path()));
            return true;
        }
        holder.remove("source");
        return false;
    }

    private int number(Map<String, JsonNode> list, JsonNode element) {
        JsonNode known = list.putIfAbsent(element.toString(), element);
        if (known == null) numbers.put(element, list.size() - 1);
        return numbers.get(known == null ? element : known);
    }

    void describe(ObjectNode gltf) {
        put(gltf, "textures", textures);
        put(gltf, "samplers", samplers);
        if (!images.json().isEmpty()) gltf.set("images", images.json());
    }

    private static void put(ObjectNode gltf, String key, Map<String, JsonNode> list) {
        if (list.isEmpty()) return;
        ArrayNode array = gltf.putArray(key);
        list.values().forEach(array::add);
    }
}
