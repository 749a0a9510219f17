package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import org.jsmesh.files.gltf.json.JsonTree;

/** Values that stand in for those of some elements of an accessor (glTF 2.0 specification, section 3.6.2.3). */
final class SparseValues {
    private final int[] elements; // in order
    private final int[] places; // of the values of each
    private final ByteBuffer values;

    private SparseValues(long[] entries, ByteBuffer values) {
        this.values = values;
        elements = new int[entries.length];
        places = new int[entries.length];
        for (int i = 0; i < entries.length; i++) {
            elements[i] = (int) (entries[i] >>> 32);
            places[i] = (int) entries[i];
        }
    }

    static SparseValues of(GltfDocument document, JsonNode json, int count, int elementBytes, String name)
            throws IOException {
        JsonNode keys = json.path("indices");
        JsonNode data = json.path("values");
        int n = JsonTree.index(json.path("count"));
        ComponentType type = ComponentType.of(keys.path("componentType"));
        int keyStart = JsonTree.index(keys.path("byteOffset"), 0);
        int dataStart = JsonTree.index(data.path("byteOffset"), 0);
        if (n < 0 || type == null || type == ComponentType.FLOAT || keyStart < 0 || dataStart < 0)
            throw document.error(name + " has incomplete sparse values");
        ByteBuffer indices = document.view(keys.path("bufferView"));
        ByteBuffer values = document.view(data.path("bufferView"));
        if (keyStart + (long) n * type.bytes() > indices.capacity()
                || dataStart + (long) n * elementBytes > values.capacity()) {
            throw document.error(name + " has sparse values outside of their buffer view");
        }
        document.unpack(16L * n);
        long[] entries = new long[n];
        for (int i = 0; i < n; i++) {
            int element = type.raw(indices, keyStart + i * type.bytes());
            if (element < 0 || element >= count)
                throw document.error(
                        name + " has a sparse value for element " + Integer.toUnsignedString(element) + " of " + count);
            entries[i] = (long) element << 32 | dataStart + i * elementBytes;
        }
        Arrays.sort(entries); // files have them in order; others are found all the same
        return new SparseValues(entries, values);
    }

    /** Where the values of an element begin, or −1. */
    int place(int element) {
        int at = Arrays.binarySearch(elements, element);
        return at < 0 ? -1 : places[at];
    }

    ByteBuffer values() {
        return values;
    }
}
