package org.jsmesh.files.gltf.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jsmesh.codec.entropy.TextModel;

/** Cuts the definition of a material to what an archive and the viewers hold. */
public final class DefinitionLimits {
    /** How deep values of a definition lie in each other at most; viewers read no more. */
    static final int DEEPEST = 64;

    private DefinitionLimits() {}

    /**
     * Drops extras that are too deep, and all extras of a definition that is too long. Then it drops extensions that
     * are too deep.
     *
     * @return what was dropped
     */
    public static List<String> cut(ObjectNode definition) {
        List<String> dropped = new ArrayList<>();
        boolean isDeep = isDeeper(definition, DEEPEST);
        boolean isLong = isLong(definition);
        if (isDeep || isLong) dropExtras(definition, DEEPEST, isLong, dropped);
        if (!isDeep) return dropped;
        for (String key : keys(definition)) {
            JsonNode value = definition.get(key);
            if (key.equals("extensions") && value instanceof ObjectNode extensions) {
                for (String name : keys(extensions)) drop(extensions, name, DEEPEST - 2, dropped);
            }
            drop(definition, key, DEEPEST - 1, dropped);
        }
        return dropped;
    }

    private static void drop(ObjectNode holder, String key, int deepest, List<String> dropped) {
        if (!isDeeper(holder.get(key), deepest)) return;
        holder.remove(key);
        dropped.add(key);
    }

    private static void dropExtras(JsonNode node, int deepest, boolean all, List<String> dropped) {
        if (deepest == 0) return;
        if (node instanceof ObjectNode object) {
            JsonNode extras = object.path("extras");
            if (!extras.isMissingNode() && (all || isDeeper(extras, deepest - 1))) {
                object.remove("extras");
                dropped.add("extras");
            }
            for (Map.Entry<String, JsonNode> entry : object.properties())
                if (!entry.getKey().equals("extras")) dropExtras(entry.getValue(), deepest - 1, all, dropped);
        } else {
            for (JsonNode element : node) dropExtras(element, deepest - 1, all, dropped);
        }
    }

    private static List<String> keys(ObjectNode object) {
        List<String> keys = new ArrayList<>();
        object.fieldNames().forEachRemaining(keys::add);
        return keys;
    }

    /** Whether objects and arrays lie more than a number of times in each other. */
    private static boolean isDeeper(JsonNode node, int deepest) {
        if (!node.isContainerNode()) return false;
        if (deepest == 0) return true;
        for (JsonNode value : node) if (isDeeper(value, deepest - 1)) return true;
        return false;
    }

    private static boolean isLong(ObjectNode definition) {
        String text = definition.toString();
        return text.length() > TextModel.MOST_BYTES / 4
                && text.getBytes(StandardCharsets.UTF_8).length > TextModel.MOST_BYTES;
    }
}
