package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Writes the header and the chunks of a GLB file (glTF 2.0 specification, section 4). */
final class GlbChunks {
    private static final int MAGIC = 0x46546C67;
    private static final int VERSION = 2;
    private static final int JSON_CHUNK = 0x4E4F534A;
    private static final int BINARY_CHUNK = 0x004E4942;
    private static final int HEADER_BYTES = 12;
    private static final int CHUNK_HEADER_BYTES = 8;

    private GlbChunks() {}

    static void write(ObjectNode gltf, BinaryChunk binary, OutputStream out) throws IOException {
        byte[] text = gltf.toString().getBytes(StandardCharsets.UTF_8);
        byte[] json = Arrays.copyOf(text, text.length + 3 & -4);
        Arrays.fill(json, text.length, json.length, (byte) ' ');
        int size = binary.size();
        long all = (long) HEADER_BYTES + CHUNK_HEADER_BYTES + json.length;
        if (size > 0) all += CHUNK_HEADER_BYTES + size;
        if (all > Integer.MAX_VALUE) throw new IllegalArgumentException("a mesh of this size does not fit a GLB file");
        out.write(words(MAGIC, VERSION, (int) all, json.length, JSON_CHUNK));
        out.write(json);
        if (size == 0) return;
        out.write(words(size, BINARY_CHUNK));
        binary.writeTo(out);
    }

    private static byte[] words(int... words) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * words.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int word : words) bytes.putInt(word);
        return bytes.array();
    }
}
