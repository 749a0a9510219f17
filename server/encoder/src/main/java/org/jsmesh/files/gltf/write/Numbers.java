package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.FloatNode;
import com.fasterxml.jackson.databind.node.IntNode;

/** Floats as numbers of JSON that give the same floats. */
final class Numbers {
    /** From here on not every whole number is a float. */
    private static final float LARGEST_WHOLE = 1 << 24;

    private Numbers() {}

    static JsonNode number(float value) {
        boolean whole = value == Math.rint(value) && Math.abs(value) < LARGEST_WHOLE;
        return whole ? IntNode.valueOf((int) value) : FloatNode.valueOf(value);
    }

    static void add(ArrayNode to, float... values) {
        for (float value : values) to.add(number(value));
    }
}
