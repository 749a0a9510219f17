package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashMap;
import java.util.Map;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.mesh.io.ModelFormatException;

/** The buffers of a file, and views of them. */
final class GltfBuffers {
    /** Most bytes that a file may unpack to, over a multiple of its own. */
    private static final long MOST_UNPACKED = 64 << 20;

    private static final int MOST_PER_BYTE = 32;

    private final GltfDocument document;
    private final ByteBuffer binary; // or null
    private final Map<Integer, ByteBuffer> buffers = new HashMap<>();
    private final Map<String, ByteBuffer> resources = new HashMap<>();
    private long given;
    private long unpacked;

    GltfBuffers(GltfDocument document, ByteBuffer binary, int fileBytes) {
        this.document = document;
        this.binary = binary;
        given = fileBytes;
    }

    long bytes() {
        return given + unpacked;
    }

    void unpack(long size) throws ModelFormatException {
        unpacked += size;
        if (isOverfull())
            throw document.error(
                    "the file unpacks to more than " + MOST_PER_BYTE + " times its bytes", "Split the scene");
    }

    /** Whether the file has been refused for what it unpacks to. */
    boolean isOverfull() {
        return unpacked > MOST_UNPACKED + MOST_PER_BYTE * given;
    }

    ByteBuffer view(JsonNode number) throws IOException {
        JsonNode view = document.element("bufferViews", number, "buffer view");
        String name = "buffer view " + number.asText();
        JsonNode packing = PackedMeshes.meshopt(view);
        if (!packing.isObject()) return slice(view, name);
        return document.packed().view(JsonTree.index(number), view, slice(packing, name));
    }

    /** The part of a buffer that an object names by buffer, byteOffset and byteLength. */
    private ByteBuffer slice(JsonNode part, String name) throws IOException {
        ByteBuffer buffer = buffer(part.path("buffer"));
        int offset = JsonTree.index(part.path("byteOffset"), 0);
        int length = JsonTree.index(part.path("byteLength"));
        if (offset < 0 || length < 0 || (long) offset + length > buffer.capacity()) {
            throw document.error(
                    name + " is not within its buffer of " + buffer.capacity() + " bytes",
                    "The file is cut off; get it again");
        }
        return buffer.slice(offset, length).order(ByteOrder.LITTLE_ENDIAN);
    }

    private ByteBuffer buffer(JsonNode number) throws IOException {
        JsonNode description = document.element("buffers", number, "buffer");
        int index = JsonTree.index(number);
        ByteBuffer known = buffers.get(index);
        if (known != null) return known;
        JsonNode uri = description.path("uri");
        ByteBuffer bytes;
        if (!uri.isTextual()) {
            if (index != 0 || binary == null) throw document.error("buffer " + index + " has no bytes");
            bytes = binary;
        } else {
            bytes = resource(uri.asText(), index);
        }
        buffers.put(index, bytes);
        return bytes;
    }

    /** Many buffers may name one file. It is read and counted once. */
    private ByteBuffer resource(String uri, int index) throws IOException {
        ByteBuffer known = resources.get(uri);
        if (known != null) return known;
        ByteBuffer bytes = ByteBuffer.wrap(document.resource(uri)
                .orElseThrow(() -> document.error(
                        "buffer " + index + " is in a file that was not found",
                        "Put all .bin files beside the .gltf file, or use .glb")));
        if (!GltfDocument.isData(uri)) given += bytes.capacity();
        resources.put(uri, bytes);
        return bytes;
    }
}
