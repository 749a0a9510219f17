package org.jsmesh.files.gltf;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import de.javagl.jgltf.impl.v2.Buffer;
import de.javagl.jgltf.impl.v2.BufferView;
import de.javagl.jgltf.impl.v2.GlTF;
import java.io.IOException;
import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.mesh.io.ResourceResolver;

/** A parsed glTF file: its objects, and checked access to the bytes that they refer to. */
final class GltfDocument {
    private static final ObjectMapper JSON =
            new ObjectMapper().configure(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES, false);

    private final String file;
    private final int fileBytes;
    private final ResourceResolver resources;
    private final ByteBuffer binary;
    private final GlTF gltf;
    private final JsonNode root;
    private final Map<Integer, ByteBuffer> buffers = new HashMap<>();
    private final Map<Integer, GltfAccessor> accessors = new HashMap<>();

    GltfDocument(String file, byte[] content, ResourceResolver resources) throws ModelFormatException {
        this.file = file;
        this.resources = resources;
        fileBytes = content.length;
        GlbContainer container = GlbContainer.of(file, content);
        binary = container.binary();
        try {
            root = JSON.readTree(new String(container.json(), StandardCharsets.UTF_8).trim());
            gltf = JSON.treeToValue(root, GlTF.class);
        } catch (JsonProcessingException e) {
            throw new ModelFormatException(
                    file, place(e), "the JSON is not glTF: " + e.getOriginalMessage(), "Export the model again");
        } catch (IllegalArgumentException | NullPointerException e) {
            throw new ModelFormatException(
                    file, "", "the JSON is not glTF: " + e.getMessage(), "Export the model again");
        }
        if (gltf == null) throw error("the JSON is empty");
        String version = root.path("asset").path("version").asText();
        if (!version.startsWith("2.")) {
            throw new ModelFormatException(
                    file, "", "glTF of version \"" + version + "\"", "Export the model as glTF 2.0");
        }
    }

    private static String place(JsonProcessingException e) {
        return e.getLocation() == null || e.getLocation().getLineNr() < 0
                ? ""
                : "line " + e.getLocation().getLineNr() + " of the JSON";
    }

    GlTF gltf() {
        return gltf;
    }

    /** The JSON itself, for numbers that the objects round to float32. */
    JsonNode root() {
        return root;
    }

    int fileBytes() {
        return fileBytes;
    }

    ModelFormatException error(String reason) {
        return new ModelFormatException(file, "", reason, "Export the model again");
    }

    ModelFormatException error(String reason, String remedy) {
        return new ModelFormatException(file, "", reason, remedy);
    }

    /** The element of a list at an index. */
    <T> T get(List<T> list, Integer index, String what) throws ModelFormatException {
        int size = list == null ? 0 : list.size();
        if (index == null || index < 0 || index >= size || list.get(index) == null) {
            throw error(what + " " + index + " does not exist (there are " + size + ")");
        }
        return list.get(index);
    }

    GltfAccessor accessor(Integer index) throws IOException {
        GltfAccessor known = accessors.get(index);
        if (known == null) {
            known = new GltfAccessor(this, get(gltf.getAccessors(), index, "accessor"), "accessor " + index);
            accessors.put(index, known);
        }
        return known;
    }

    /** The bytes of a buffer view, little endian, from position 0. */
    ByteBuffer view(Integer index) throws IOException {
        BufferView view = get(gltf.getBufferViews(), index, "buffer view");
        ByteBuffer buffer = buffer(view.getBuffer());
        long offset = view.getByteOffset() == null ? 0 : view.getByteOffset();
        long length = view.getByteLength() == null ? -1 : view.getByteLength();
        if (offset < 0 || length < 0 || offset + length > buffer.capacity()) {
            throw error(
                    "buffer view " + index + " is not within its buffer of " + buffer.capacity() + " bytes",
                    "The file is cut off; get it again");
        }
        return buffer.slice((int) offset, (int) length).order(ByteOrder.LITTLE_ENDIAN);
    }

    private ByteBuffer buffer(Integer index) throws IOException {
        Buffer description = get(gltf.getBuffers(), index, "buffer");
        ByteBuffer known = buffers.get(index);
        if (known != null) return known;
        ByteBuffer bytes;
        if (description.getUri() == null) {
            if (index != 0 || binary == null) throw error("buffer " + index + " has no bytes");
            bytes = binary;
        } else {
            bytes = ByteBuffer.wrap(resource(description.getUri())
                    .orElseThrow(() -> error(
                            "buffer " + index + " is in a file that was not found",
                            "Put all .bin files beside the .gltf file, or use .glb")));
        }
        buffers.put(index, bytes);
        return bytes;
    }

    /** The bytes behind a data URI or beside the file. */
    Optional<byte[]> resource(String uri) throws IOException {
        if (!uri.startsWith("data:")) return resources.find(path(uri));
        int comma = uri.indexOf(',');
        if (comma < 0) throw error("a data URI without data");
        try {
            return Optional.of(Base64.getMimeDecoder().decode(uri.substring(comma + 1)));
        } catch (IllegalArgumentException e) {
            throw error("a data URI that is not base64");
        }
    }

    /** The path of a relative URI. */
    static String path(String uri) {
        try {
            return URLDecoder.decode(uri.replace("+", "%2B"), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException e) {
            return uri;
        }
    }
}
