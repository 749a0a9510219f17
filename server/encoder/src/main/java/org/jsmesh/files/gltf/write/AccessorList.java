package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import org.jsmesh.files.gltf.read.ComponentType;
import org.jsmesh.mesh.Mesh;

/** The accessors of a file. Each has the values of the vertices of one primitive, and no others. */
final class AccessorList {
    private final ArrayNode accessors = JsonNodeFactory.instance.arrayNode();
    private final BinaryChunk buffer;

    AccessorList(BinaryChunk buffer) {
        this.buffer = buffer;
    }

    ArrayNode json() {
        return accessors;
    }

    /** The positions of wedges; their bounds are exact. */
    int positions(Mesh mesh, int[] wedges) {
        float[] low = new float[3];
        float[] high = new float[3];
        Arrays.fill(low, Float.POSITIVE_INFINITY);
        Arrays.fill(high, Float.NEGATIVE_INFINITY);
        BinaryChunk.View view = buffer.of(BinaryChunk.ARRAY_BUFFER, 12);
        ObjectNode json = accessor(view, ComponentType.FLOAT, wedges.length, 3);
        for (int wedge : wedges) {
            for (int i = 0; i < 3; i++) {
                float value = mesh.positions()[3 * mesh.wedgeVertices()[wedge] + i];
                low[i] = Math.min(low[i], value);
                high[i] = Math.max(high[i], value);
                view.bytes().put(Float.floatToRawIntBits(value), 4);
            }
        }
        Numbers.add(json.putArray("min"), low);
        Numbers.add(json.putArray("max"), high);
        return accessors.size() - 1;
    }

    /** The values of wedges. */
    int values(VertexAttribute attribute, int[] wedges) {
        BinaryChunk.View view = buffer.of(BinaryChunk.ARRAY_BUFFER, attribute.stride());
        ObjectNode json = accessor(view, attribute.type(), wedges.length, attribute.components());
        if (attribute.normalized()) json.put("normalized", true);
        if (attribute.extras() != null) json.set("extras", attribute.extras().deepCopy());
        for (int wedge : wedges) {
            for (int k = 0; k < attribute.components(); k++)
                view.bytes()
                        .put(attribute.values().raw(wedge, k), attribute.type().bytes());
            view.bytes().pad();
        }
        return accessors.size() - 1;
    }

    /** Indices of the smallest type whose largest number, which some programs take for a break, is none of them. */
    int indices(int[] indices, int vertices) {
        ComponentType type = vertices <= 0xFF
                ? ComponentType.UNSIGNED_BYTE
                : vertices <= 0xFFFF ? ComponentType.UNSIGNED_SHORT : ComponentType.UNSIGNED_INT;
        BinaryChunk.View view = buffer.of(BinaryChunk.ELEMENT_ARRAY_BUFFER, type.bytes());
        accessor(view, type, indices.length, 1);
        for (int index : indices) view.bytes().put(index, type.bytes());
        return accessors.size() - 1;
    }

    private ObjectNode accessor(BinaryChunk.View view, ComponentType type, int count, int components) {
        ObjectNode json = accessors.addObject().put("bufferView", view.number());
        if (view.bytes().size() > 0) json.put("byteOffset", view.bytes().size());
        json.put("componentType", type.code()).put("count", count);
        return json.put("type", components == 1 ? "SCALAR" : "VEC" + components);
    }
}
