package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32;
import org.jsmesh.mesh.Sizes;

/** The one buffer of a GLB file with its views. Each view starts at a multiple of four. */
final class BinaryChunk {
    static final int ARRAY_BUFFER = 34962;
    static final int ELEMENT_ARRAY_BUFFER = 34963;

    /**
     * A part of the buffer.
     *
     * @param number of the view
     * @param stride bytes from one vertex to the next; 0 where that says nothing
     * @param target what it is for; 0 where that says nothing
     */
    record View(int number, int stride, int target, Bytes bytes) {}

    /** Bytes that grow, little endian. */
    static final class Bytes {
        private byte[] content = new byte[1024];
        private int size;

        int size() {
            return size;
        }

        void put(int value, int count) {
            if (size > Integer.MAX_VALUE - 64) throw tooLarge();
            if (size + count > content.length)
                content = Arrays.copyOf(content, (int) Math.min(Sizes.MOST, 2L * content.length));
            for (int i = 0; i < count; i++) content[size++] = (byte) (value >> 8 * i);
        }

        void pad() {
            while (size % 4 != 0) put(0, 1);
        }
    }

    private final List<View> views = new ArrayList<>();
    private final Map<List<Integer>, View> shared = new HashMap<>();
    private final Map<Long, List<View>> images = new HashMap<>();

    /** The view of all vertices with a stride, or of all indices of so many bytes. */
    View of(int target, int bytes) {
        return shared.computeIfAbsent(
                List.of(target, bytes), key -> add(target == ARRAY_BUFFER ? bytes : 0, target, new Bytes()));
    }

    /** The number of a view with this content: one for all images that are the same. */
    int image(byte[] content) {
        CRC32 crc = new CRC32();
        crc.update(content);
        List<View> alike = images.computeIfAbsent(crc.getValue(), key -> new ArrayList<>());
        for (View view : alike) if (Arrays.equals(view.bytes.content, content)) return view.number;
        Bytes bytes = new Bytes();
        bytes.content = content;
        bytes.size = content.length;
        View view = add(0, 0, bytes);
        alike.add(view);
        return view.number;
    }

    private View add(int stride, int target, Bytes bytes) {
        View view = new View(views.size(), stride, target, bytes);
        views.add(view);
        return view;
    }

    private static IllegalArgumentException tooLarge() {
        return new IllegalArgumentException("a mesh of this size does not fit a GLB file");
    }

    /** Bytes of all views, up to a multiple of four. */
    int size() {
        long size = 0;
        for (View view : views) size += view.bytes.size + 3L & -4;
        if (size > Integer.MAX_VALUE - 64) throw tooLarge();
        return (int) size;
    }

    void describe(ObjectNode gltf) {
        if (size() == 0) return;
        ArrayNode list = gltf.putArray("bufferViews");
        int offset = 0;
        for (View view : views) {
            Map<String, Integer> values = new LinkedHashMap<>();
            values.put("byteOffset", offset);
            values.put("byteLength", view.bytes.size);
            values.put("byteStride", view.stride);
            values.put("target", view.target);
            ObjectNode json = list.addObject().put("buffer", 0);
            values.forEach((key, value) -> {
                if (value != 0) json.put(key, value);
            });
            offset += view.bytes.size + 3 & -4;
        }
        gltf.putArray("buffers").addObject().put("byteLength", offset);
    }

    void writeTo(OutputStream out) throws IOException {
        for (View view : views) {
            out.write(view.bytes.content, 0, view.bytes.size);
            out.write(new byte[3], 0, -view.bytes.size & 3);
        }
    }
}
