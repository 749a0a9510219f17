package org.jsmesh.spark;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/**
 * A companion that an encoding asked for.
 *
 * @param asked its path as the model file gives it
 * @param found where it was, relative to the model file; null where none was
 * @param tag of the version that was read; null likewise
 */
record CompanionTag(String asked, String found, String tag) {
    private static final ObjectMapper JSON = new ObjectMapper();

    /** {@return companions as a JSON array; empty text for none} */
    static String toJson(Collection<CompanionTag> companions) {
        if (companions.isEmpty()) return "";
        ArrayNode rows = JSON.createArrayNode();
        for (CompanionTag c : companions)
            rows.addObject().put("asked", c.asked).put("found", c.found).put("tag", c.tag);
        return rows.toString();
    }

    /**
     * Reads what {@link #toJson} wrote.
     *
     * @throws IllegalArgumentException when it is something else
     */
    static List<CompanionTag> fromJson(String text) {
        List<CompanionTag> companions = new ArrayList<>();
        if (text.isEmpty()) return companions;
        try {
            for (JsonNode row : JSON.readTree(text)) {
                String found = row.path("found").textValue();
                companions.add(new CompanionTag(
                        row.path("asked").asText(), found, row.path("tag").textValue()));
            }
            return companions;
        } catch (JsonProcessingException e) {
            throw new IllegalArgumentException("no list of companions: " + text, e);
        }
    }
}
