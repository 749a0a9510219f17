package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.jsmesh.files.gltf.json.DataUri;
import org.jsmesh.files.gltf.json.JsonFault;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.files.gltf.json.LongNames;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.mesh.io.ResourceResolver;

/** A parsed glTF file: its JSON tree, and checked access to the bytes that it refers to. */
final class GltfDocument {
    /** Most triangles of a scene. One mesh may appear in many nodes, and nobody means a model with more. */
    private static final int MOST_ELEMENTS = 50_000_000;

    /** Most triangles that repeat others, over the number of bytes. */
    private static final int MOST_REPEATED = 4_000_000;

    /** Most elements that have no bytes at all, over the number of bytes. */
    private static final int MOST_ZEROS = 250_000;

    private final String file;
    private final ResourceResolver resources;
    private final int mostFaces;
    private final JsonNode root;
    private final GltfBuffers buffers;
    private final PackedMeshes packed = new PackedMeshes(this);
    private final LongNames names = new LongNames();
    private final Map<Integer, GltfAccessor> accessors = new HashMap<>();

    GltfDocument(String file, byte[] content, ResourceResolver resources, int mostFaces) throws IOException {
        this.file = file;
        this.mostFaces = mostFaces;
        this.resources = resources;
        GlbContainer container = GlbContainer.of(file, content);
        try {
            root = JsonTree.of(text(container.json()));
        } catch (JsonFault e) {
            throw new ModelFormatException(
                    file, e.place(), "the JSON is damaged: " + e.getMessage(), "Export the model again");
        }
        if (root.isMissingNode()) throw error("the JSON is empty");
        if (!root.isObject()) throw error("the JSON is not glTF: it is no object");
        String version = root.path("asset").path("version").asText();
        if (!version.equals("2") && !version.startsWith("2.")) {
            throw new ModelFormatException(
                    file, "", "glTF of version \"" + version + "\"", "Export the model as glTF 2.0");
        }
        buffers = new GltfBuffers(this, container.binary(), content.length);
    }

    private static String text(byte[] json) {
        String text = new String(json, StandardCharsets.UTF_8).trim();
        return text.startsWith("\uFEFF") ? text.substring(1) : text;
    }

    JsonNode root() {
        return root;
    }

    /** Bytes of the file, of the buffers beside it, and of what was unpacked; limits grow with them. */
    long bytes() {
        return buffers.bytes();
    }

    /** Most triangles, with those that repeat others. */
    int mostElements() {
        return (int) Math.min(MOST_ELEMENTS, MOST_REPEATED + bytes());
    }

    /** Most elements of an accessor without bytes, and most triangles made of them. */
    int mostZeros() {
        return (int) Math.min(MOST_ELEMENTS, MOST_ZEROS + bytes());
    }

    /** Most triangles that the caller takes. */
    int mostFaces() {
        return mostFaces;
    }

    /** Shortens names of the file. */
    LongNames names() {
        return names;
    }

    PackedMeshes packed() {
        return packed;
    }

    ModelFormatException error(String reason) {
        return error(reason, "Export the model again");
    }

    ModelFormatException error(String reason, String remedy) {
        return new ModelFormatException(file, "", reason, remedy);
    }

    /** The object at an index of a list of the root. */
    JsonNode element(String list, JsonNode index, String what) throws ModelFormatException {
        return element(
                list, JsonTree.index(index), what + " " + (index.isNumber() ? index.asText() : "without number"));
    }

    /** The object at an index of a list of the root. */
    JsonNode element(String list, int index, String name) throws ModelFormatException {
        JsonNode element = index < 0 ? root.path("") : root.path(list).path(index);
        if (element.isObject()) return element;
        throw error(name + " does not exist (there are " + root.path(list).size() + ")");
    }

    GltfAccessor accessor(JsonNode number) throws IOException {
        JsonNode json = element("accessors", number, "accessor");
        int index = JsonTree.index(number);
        GltfAccessor known = accessors.get(index);
        if (known == null) {
            known = GltfAccessor.of(this, json, "accessor " + index);
            accessors.put(index, known);
        }
        return known;
    }

    /** The bytes of a buffer view, little endian, from position 0. */
    ByteBuffer view(JsonNode number) throws IOException {
        return buffers.view(number);
    }

    /** Counts bytes that are made of few, and refuses a file that makes too many. */
    void unpack(long size) throws ModelFormatException {
        buffers.unpack(size);
    }

    /** Whether {@link #unpack} has refused the file. */
    boolean isOverfull() {
        return buffers.isOverfull();
    }

    /** The bytes behind a data URI or beside the file. */
    Optional<byte[]> resource(String uri) throws IOException {
        if (!isData(uri)) return beside(path(uri));
        byte[] bytes = DataUri.bytes(uri);
        if (bytes == null) throw error("a data URI that cannot be decoded");
        return Optional.of(bytes);
    }

    /** The bytes of a file beside this one, by its path. */
    Optional<byte[]> beside(String path) throws IOException {
        return resources.find(path);
    }

    static boolean isData(String uri) {
        return DataUri.is(uri);
    }

    /** The path of a relative URI. */
    static String path(String uri) {
        String path = DataUri.percentDecoded(uri);
        return path == null ? uri : path;
    }
}
