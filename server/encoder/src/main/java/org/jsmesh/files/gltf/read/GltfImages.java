package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.BitSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jsmesh.files.gltf.json.GltfExtras;
import org.jsmesh.files.gltf.json.ImageType;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.files.gltf.json.LongNames;
import org.jsmesh.mesh.io.ModelFormatException;

/**
 * The images of a glTF file by path: the path of a file beside it, or a name for bytes within it, with the extension of
 * what they are. Only images that are asked for are looked at.
 */
final class GltfImages {
    /** Kept free for the number before a name and the extension behind it. */
    private static final int BYTES_AROUND = 64;

    private final GltfDocument document;
    private final JsonNode images;
    private final Map<Integer, String> paths = new HashMap<>();
    private final Map<String, Integer> byPath = new HashMap<>();
    private final Set<String> beside = new HashSet<>();
    private final Map<Integer, byte[]> within = new HashMap<>();
    private final BitSet broken = new BitSet();
    private final Set<String> damaged = new LinkedHashSet<>();
    private Map<String, Integer> named; // null until it is asked for

    GltfImages(GltfDocument document) {
        this.document = document;
        images = document.root().path("images");
        for (JsonNode image : images)
            if (isBeside(image)) beside.add(GltfDocument.path(image.path("uri").asText()));
    }

    private static boolean isBeside(JsonNode image) {
        JsonNode uri = image.path("uri");
        return uri.isTextual() && !GltfDocument.isData(uri.asText());
    }

    /** The path of an image, or null when the file has no such image. */
    String path(int image) throws IOException {
        JsonNode given = image < 0 ? images.path("") : images.path(image);
        if (!given.isObject()) return null;
        String known = paths.get(image);
        if (known == null) {
            known = isBeside(given) ? GltfDocument.path(given.path("uri").asText()) : name(given, image);
            known = document.names().fit(known);
            paths.put(image, known);
            byPath.putIfAbsent(known, image);
        }
        return known;
    }

    /** A name that no other image has. */
    private String name(JsonNode image, int index) throws IOException {
        String name =
                image.path("extras").path(GltfExtras.JSM).path(GltfExtras.PATH).asText();
        if (name.isBlank()) {
            name = image.path("name").asText();
            if (name.isBlank()) name = "image" + index;
            ImageType type = type(image, index);
            if (!type.isEndOf(name) || !LongNames.fits(name, BYTES_AROUND / 2))
                name = document.names().fit(name, BYTES_AROUND) + type.suffix();
        }
        name = document.names().fit(name, BYTES_AROUND / 2);
        String unique = name;
        for (int i = index; beside.contains(unique) || byPath.containsKey(unique); i += images.size())
            unique = i + "-" + name;
        return unique;
    }

    private ImageType type(JsonNode image, int index) throws IOException {
        ImageType type = ImageType.of(within(index, image).orElse(new byte[0]));
        return type == ImageType.OTHER ? ImageType.named(image.path("mimeType").asText()) : type;
    }

    /** The bytes of an image that is not beside the file. */
    private Optional<byte[]> within(int index, JsonNode image) throws IOException {
        byte[] known = within.get(index);
        if (known != null) return Optional.of(known);
        if (broken.get(index)) return Optional.empty();
        try {
            Optional<byte[]> bytes = read(image);
            bytes.ifPresent(found -> within.put(index, found));
            return bytes;
        } catch (ModelFormatException e) {
            if (document.isOverfull()) throw e;
            broken.set(index);
            return Optional.empty();
        }
    }

    private Optional<byte[]> read(JsonNode image) throws IOException {
        if (image.path("uri").isTextual())
            return document.resource(image.path("uri").asText());
        if (!JsonTree.isGiven(image.path("bufferView"))) return Optional.empty();
        ByteBuffer view = document.view(image.path("bufferView"));
        document.unpack(view.remaining());
        byte[] copy = new byte[view.remaining()];
        view.get(copy);
        return Optional.of(copy);
    }

    /** The bytes of an image, or of a file beside the model when no image has this path. */
    Optional<byte[]> bytes(String path) throws IOException {
        Integer index = byPath.get(path);
        if (index == null) index = named().get(path);
        if (index == null || isBeside(images.get(index))) return document.beside(path);
        Optional<byte[]> bytes = within(index, images.get(index));
        if (bytes.isEmpty() && broken.get(index)) damaged.add(path);
        return bytes;
    }

    /** Paths of images within the file that were asked for and cannot be read. */
    Set<String> damaged() {
        return damaged;
    }

    /** The first image within the file of each name. */
    private Map<String, Integer> named() {
        if (named != null) return named;
        named = new HashMap<>();
        for (int i = 0; i < images.size(); i++) {
            JsonNode image = images.get(i);
            if (image.isObject() && !isBeside(image))
                named.putIfAbsent(image.path("name").asText(), i);
        }
        return named;
    }
}
