package org.jsmesh.files.gltf.write;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** The extensions that a file uses, and those that a program must know to read it. */
final class ExtensionNames {
    private final Set<String> used = new TreeSet<>();
    private final Set<String> required = new TreeSet<>();

    void require(String name) {
        used.add(name);
        required.add(name);
    }

    /** Takes the names of all extensions within a part of the file. */
    void use(JsonNode part) {
        for (Map.Entry<String, JsonNode> entry : part.properties()) {
            if (entry.getKey().equals("extras")) continue;
            if (entry.getKey().equals("extensions"))
                entry.getValue().fieldNames().forEachRemaining(used::add);
            use(entry.getValue());
        }
        if (part.isArray()) part.forEach(this::use);
    }

    void describe(ObjectNode gltf) {
        if (!used.isEmpty()) used.forEach(gltf.putArray("extensionsUsed")::add);
        if (!required.isEmpty()) required.forEach(gltf.putArray("extensionsRequired")::add);
    }
}
