package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.files.gltf.draco.DracoAttribute;
import org.jsmesh.files.gltf.json.GltfExtras;
import org.jsmesh.files.gltf.json.JsonTree;
import org.jsmesh.mesh.io.ModelFormatException;

/** A part of a mesh with one material: the accessors that it uses, unpacked where they are packed. */
final class GltfPrimitive {
    private final GltfDocument document;
    private final JsonNode json;
    private int mode;
    private GltfAccessor indices; // or null
    private final Map<String, GltfAccessor> attributes = new LinkedHashMap<>();
    private final List<String> unusable = new ArrayList<>();

    /** One that has triangles. */
    private GltfPrimitive(GltfDocument document, JsonNode json) throws IOException {
        this.document = document;
        this.json = json;
        JsonNode positions = json.path("attributes").path("POSITION");
        JsonNode packing = PackedMeshes.draco(json);
        boolean packed = packing.isObject() && !hasBytes(positions);
        if (packed) unpack(packing);
        for (Map.Entry<String, JsonNode> entry : json.path("attributes").properties()) {
            String name = entry.getKey();
            if (!JsonTree.isGiven(entry.getValue()) || attributes.containsKey(name)) continue;
            if (isCopy(entry.getValue())) continue;
            boolean lost = packed && !hasBytes(entry.getValue());
            if (name.equals("POSITION")) attributes.put(name, document.accessor(entry.getValue()));
            else if (lost || !isUsable(name, entry.getValue()) || !take(name, entry.getValue())) unusable.add(name);
        }
        JsonNode number = json.path("indices");
        if (packed) return;
        mode = mode(json);
        indices = JsonTree.isGiven(number) ? document.accessor(number) : null;
    }

    /** Whether the accessor of an attribute can be read. */
    private boolean take(String name, JsonNode accessor) throws IOException {
        try {
            attributes.put(name, document.accessor(accessor));
            return true;
        } catch (ModelFormatException e) {
            if (document.isOverfull()) throw e;
            return false;
        }
    }

    /** An accessor without a buffer view stands for a packed one. */
    private boolean hasBytes(JsonNode accessor) {
        JsonNode json = json(accessor);
        return JsonTree.isGiven(json.path("bufferView")) || JsonTree.isGiven(json.path("sparse"));
    }

    private JsonNode json(JsonNode accessor) {
        int index = JsonTree.index(accessor);
        JsonNode accessors = document.root().path("accessors");
        return index < 0 ? accessors.path("") : accessors.path(index);
    }

    private void unpack(JsonNode packing) throws IOException {
        PackedMeshes.Draco draco = document.packed().mesh(packing);
        for (Map.Entry<String, JsonNode> entry : packing.path("attributes").properties()) {
            String name = entry.getKey();
            DracoAttribute found = draco.mesh().attribute(JsonTree.index(entry.getValue()));
            ComponentType type = found == null ? null : ComponentType.of(found.componentType());
            boolean kept = name.equals("POSITION") || BakedAttribute.isKept(name);
            if (!kept || type == null || found.components() < 1 || found.components() > 4) continue;
            boolean normalized = found.normalized()
                    || json(json.path("attributes").path(name))
                            .path("normalized")
                            .booleanValue();
            String what = "the compressed " + name;
            attributes.put(name, GltfAccessor.of(document, what, found.components(), type, normalized, found.values()));
        }
        if (!attributes.containsKey("POSITION"))
            throw document.error("a mesh compressed with Draco has no positions", "Export it without compression");
        indices = draco.indices();
        mode = TriangleSource.TRIANGLES;
    }

    /** Null for points, lines, unknown kinds, and what has no positions. */
    static GltfPrimitive of(GltfDocument document, JsonNode json) throws IOException {
        boolean given = JsonTree.isGiven(json.path("attributes").path("POSITION"));
        return given && TriangleSource.isOfTriangles(mode(json)) ? new GltfPrimitive(document, json) : null;
    }

    private static int mode(JsonNode json) {
        return JsonTree.index(json.path("mode"), TriangleSource.TRIANGLES);
    }

    /** Whether another attribute of the primitive has the values themselves. */
    private boolean isCopy(JsonNode accessor) {
        JsonNode of = json(accessor).path("extras").path(GltfExtras.JSM).path(GltfExtras.COPY_OF);
        return of.isTextual() && json.path("attributes").has(of.asText());
    }

    private boolean isUsable(String name, JsonNode accessor) {
        if (!BakedAttribute.isKept(name)) return false;
        return GltfAccessor.width(json(accessor)) > 0;
    }

    GltfAccessor positions() throws IOException {
        GltfAccessor positions = attributes.get("POSITION");
        if (positions.components() != 3) throw document.error("POSITION has " + positions.components() + " components");
        return positions;
    }

    /** All that the file gives and a channel can hold, positions included, in the order of the file. */
    Map<String, GltfAccessor> attributes() {
        return attributes;
    }

    /** Attributes of a kind that no channel holds. */
    List<String> unusable() {
        return unusable;
    }

    TriangleSource triangles() throws IOException {
        return new TriangleSource(document, mode, indices, positions().count());
    }

    /** Whether the triangles are made of bytes, and not of zeros alone. */
    boolean hasBytes() throws IOException {
        return (indices == null ? positions() : indices).hasBytes();
    }

    /** glTF's number of the material, or −1. */
    int material() {
        return JsonTree.index(json.path("material"));
    }

    int morphTargets() {
        return json.path("targets").size();
    }
}
