package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.files.gltf.json.GltfExtras;
import org.jsmesh.files.gltf.json.ImageType;
import org.jsmesh.mesh.Texture;

/**
 * The images of a file, one for each path. Those with the same bytes have them once. An image that the mesh lacks is
 * named by its path, as a file beside this one.
 */
final class ImageList {
    private final ArrayNode images = JsonNodeFactory.instance.arrayNode();
    private final Map<String, Integer> numbers = new HashMap<>();
    private final Map<String, Texture> textures = new HashMap<>();
    private boolean other;

    ImageList(List<Texture> given, BinaryChunk buffer) {
        for (Texture texture : given) {
            if (textures.putIfAbsent(texture.path(), texture) != null) continue;
            ImageType type = ImageType.of(texture.bytes());
            other |= !type.isKnown();
            numbers.put(texture.path(), images.size());
            ObjectNode image = images.addObject().put("name", texture.path());
            ImageType said = said(type, texture.path());
            image.put("mimeType", said.mimeType()).put("bufferView", buffer.image(texture.bytes()));
            ImageType read = type == ImageType.OTHER ? said : type;
            if (texture.path().isBlank() || !read.isEndOf(texture.path()))
                image.putObject("extras").putObject(GltfExtras.JSM).put(GltfExtras.PATH, texture.path());
        }
    }

    /** Textures may have no others than PNG and JPEG but by extensions. Viewers look at the bytes. */
    private static ImageType said(ImageType type, String path) {
        if (type.isKnown()) return type;
        return ImageType.JPEG.isEndOf(path) ? ImageType.JPEG : ImageType.PNG;
    }

    ArrayNode json() {
        return images;
    }

    /** Whether there are images of formats that glTF does not have. */
    boolean hasOther() {
        return other;
    }

    /** The bytes of an image, or null. */
    byte[] bytes(String path) {
        Texture texture = textures.get(path);
        return texture == null ? null : texture.bytes();
    }

    int number(String path) {
        Integer known = numbers.get(path);
        if (known != null) return known;
        numbers.put(path, images.size());
        String uri = URLEncoder.encode(path, StandardCharsets.UTF_8);
        images.addObject().put("uri", uri.replace("+", "%20").replace("%2F", "/"));
        return images.size() - 1;
    }
}
