package org.jsmesh.files.gltf.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiConsumer;

/** What a file has beside meshes and materials, and a mesh does not keep. */
public final class DroppedParts {
    /** They tell how to read the file, and which program wrote it. */
    private static final Set<String> OF_THE_FORMAT =
            Set.of("version", "minVersion", "generator", "extras", "extensions");

    private DroppedParts() {}

    /** Names of cameras. */
    public static List<String> cameras(JsonNode root) {
        List<String> names = new ArrayList<>();
        JsonNode cameras = root.path("cameras");
        for (int i = 0; i < cameras.size(); i++) names.add(name(cameras.path(i), "camera " + i));
        return names;
    }

    private static String name(JsonNode part, String otherwise) {
        String name = part.path("name").asText();
        return name.isBlank() ? otherwise : name;
    }

    /** Parts that have extras of other programs. */
    public static List<String> extras(JsonNode root) {
        List<String> parts = new ArrayList<>();
        forEach(root, (name, part) -> {
            if (hasExtras(part.path("extras"))) parts.add(name);
        });
        return parts;
    }

    private static boolean hasExtras(JsonNode extras) {
        boolean own = extras.size() == 1 && extras.has(GltfExtras.JSM);
        return JsonTree.isGiven(extras) && !own && !(extras.isContainerNode() && extras.isEmpty());
    }

    /** Names of extensions of parts, whether the file lists them or not. */
    public static Set<String> extensions(JsonNode root) {
        Set<String> names = new TreeSet<>();
        forEach(root, (name, part) -> part.path("extensions").fieldNames().forEachRemaining(names::add));
        return names;
    }

    private static void forEach(JsonNode root, BiConsumer<String, JsonNode> action) {
        action.accept("file", root);
        action.accept("asset", root.path("asset"));
        forEach(root.path("scenes"), "scene ", action);
        forEach(root.path("nodes"), "node ", action);
        JsonNode meshes = root.path("meshes");
        forEach(meshes, "mesh ", action);
        for (int i = 0; i < meshes.size(); i++)
            forEach(meshes.path(i).path("primitives"), "mesh " + i + " primitive ", action);
    }

    private static void forEach(JsonNode list, String name, BiConsumer<String, JsonNode> action) {
        for (int i = 0; i < list.size(); i++) action.accept(name + i, list.path(i));
    }

    /** What the file says of itself and its rights, as key and value. */
    public static List<String> metadata(JsonNode root) {
        List<String> found = new ArrayList<>();
        for (Map.Entry<String, JsonNode> entry : root.path("asset").properties()) {
            String value = entry.getValue().asText();
            if (!OF_THE_FORMAT.contains(entry.getKey()) && JsonTree.isGiven(entry.getValue()))
                found.add(entry.getKey() + (value.isEmpty() ? "" : " " + value));
        }
        return found;
    }
}
