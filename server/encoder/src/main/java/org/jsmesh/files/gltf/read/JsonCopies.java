package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.HashMap;
import java.util.Map;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.mesh.io.ModelFormatException;

/** Copies of objects that stand once in the JSON and are wanted in many places. They count against the limit. */
final class JsonCopies {
    /** Bytes of a tree for a character of its text. */
    private static final int BYTES_PER_CHARACTER = 16;

    private final GltfDocument document;
    private final Map<JsonNode, Integer> lengths = new HashMap<>();
    private final String list;

    /** @param list the property of the root that has the objects */
    JsonCopies(GltfDocument document, String list) {
        this.document = document;
        this.list = list;
    }

    /** A copy of an object, or null when there is none of that number. */
    ObjectNode copy(JsonNode number) throws ModelFormatException {
        int index = JsonTree.index(number);
        if (index < 0 || !(document.root().path(list).path(index) instanceof ObjectNode object)) return null;
        Integer length = lengths.get(number);
        if (length == null) {
            length = object.toString().length();
            lengths.put(number, length);
        }
        document.unpack((long) BYTES_PER_CHARACTER * length);
        return object.deepCopy();
    }
}
