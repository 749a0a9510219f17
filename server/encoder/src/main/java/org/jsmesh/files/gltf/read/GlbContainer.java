package org.jsmesh.files.gltf.read;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.jsmesh.mesh.io.ModelFormatException;

/**
 * The chunks of a GLB file (glTF 2.0 specification, section 4): the JSON text, and the binary chunk for buffer 0. A
 * glTF file that is JSON only has no binary chunk.
 *
 * @param binary or null
 */
record GlbContainer(byte[] json, ByteBuffer binary) {
    private static final int MAGIC = 0x46546C67;
    private static final int JSON_CHUNK = 0x4E4F534A;
    private static final int BINARY_CHUNK = 0x004E4942;
    private static final int HEADER_BYTES = 12;
    private static final int CHUNK_HEADER_BYTES = 8;

    static GlbContainer of(String file, byte[] content) throws ModelFormatException {
        ByteBuffer data = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
        if (content.length < 4 || data.getInt(0) != MAGIC) return new GlbContainer(content, null);
        if (content.length < HEADER_BYTES) throw cutOff(file, content.length);
        int version = data.getInt(4);
        if (version != 2) {
            throw new ModelFormatException(
                    file, "byte 4", "glTF of version " + version, "Export the model as glTF 2.0");
        }
        long length = data.getInt(8) & 0xFFFFFFFFL;
        if (length > content.length) throw cutOff(file, content.length);
        byte[] json = null;
        ByteBuffer binary = null;
        long at = HEADER_BYTES;
        while (at + CHUNK_HEADER_BYTES <= length) {
            long size = data.getInt((int) at) & 0xFFFFFFFFL;
            int type = data.getInt((int) at + 4);
            int start = (int) at + CHUNK_HEADER_BYTES;
            if (start + size > length) throw cutOff(file, at);
            if (type == JSON_CHUNK && json == null) json = Arrays.copyOfRange(content, start, (int) (start + size));
            if (type == BINARY_CHUNK && binary == null) binary = data.slice(start, (int) size);
            at = start + size;
        }
        if (json == null)
            throw new ModelFormatException(
                    file, "byte 12", "there is no JSON chunk", "The file is damaged; get it again");
        return new GlbContainer(json, binary);
    }

    private static ModelFormatException cutOff(String file, long offset) {
        return new ModelFormatException(
                file, "byte " + offset, "the file ends within a chunk", "The file is cut off; get it again");
    }
}
