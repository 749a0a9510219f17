package org.jsmesh.files.gltf.read;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Map;
import org.jsmesh.files.gltf.json.JsonTree;

/**
 * The values of an accessor (glTF 2.0 specification, section 3.6.2). They are read where they lie, so that an accessor
 * takes no memory. One without a buffer view has zeros, and sparse values stand in for those of their elements.
 */
final class GltfAccessor {
    private static final Map<String, Integer> COMPONENTS = Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4);

    private final GltfDocument document;
    private final String name;
    private final int components;
    private final ComponentType type;
    private final boolean normalized;
    private final int count;
    private final ByteBuffer view; // or null: zeros
    private final int start;
    private final int step;
    private final SparseValues sparse; // or null
    private final KeptChannel kept; // or null

    private GltfAccessor(GltfDocument document, JsonNode json, String name) throws IOException {
        this.document = document;
        this.name = name;
        components = width(json);
        if (components == 0)
            throw document.error(name + " is of type " + json.path("type").asText() + ", not a scalar or vector");
        type = ComponentType.of(json.path("componentType"));
        if (type == null) throw document.error(name + " has the component type " + json.path("componentType"));
        normalized = json.path("normalized").booleanValue();
        count = JsonTree.index(json.path("count"));
        if (count < 0) throw document.error(name + " has no count");
        JsonNode number = json.path("bufferView");
        view = JsonTree.isGiven(number) ? document.view(number) : null;
        int elementBytes = components * type.bytes();
        int stride = view == null
                ? 0
                : JsonTree.index(
                        document.root()
                                .path("bufferViews")
                                .path(JsonTree.index(number))
                                .path("byteStride"),
                        0);
        step = stride == 0 ? elementBytes : stride;
        start = JsonTree.index(json.path("byteOffset"), 0);
        if (step < elementBytes || start < 0) throw document.error(name + " has a stride or an offset that cannot be");
        if (view != null && count > 0 && start + step * (count - 1L) + elementBytes > view.capacity())
            throw tooShort(view.capacity());
        if (view == null && count > document.mostZeros())
            throw document.error(name + " has " + count + " elements without bytes");
        kept = KeptChannel.of(json, type, components);
        JsonNode parts = json.path("sparse");
        sparse = JsonTree.isGiven(parts) ? SparseValues.of(document, parts, count, elementBytes, name) : null;
    }

    private GltfAccessor(
            GltfDocument document, String name, int components, ComponentType type, boolean normalized, byte[] values) {
        this.document = document;
        this.name = name;
        this.components = components;
        this.type = type;
        this.normalized = normalized;
        view = ByteBuffer.wrap(values).order(ByteOrder.LITTLE_ENDIAN);
        start = 0;
        step = components * type.bytes();
        count = values.length / step;
        sparse = null;
        kept = null;
    }

    static GltfAccessor of(GltfDocument document, JsonNode json, String name) throws IOException {
        return new GltfAccessor(document, json, name);
    }

    /** Values that were unpacked: little endian, without gaps. */
    static GltfAccessor of(
            GltfDocument document, String name, int components, ComponentType type, boolean normalized, byte[] values) {
        return new GltfAccessor(document, name, components, type, normalized, values);
    }

    /** Components of an element; 0 for matrices and what is no type. */
    static int width(JsonNode json) {
        return COMPONENTS.getOrDefault(json.path("type").asText(), 0);
    }

    private IOException tooShort(int available) {
        return document.error(
                name + " needs more bytes than its buffer view has (" + available + ")",
                "The file is cut off; get it again");
    }

    /** Whether bytes of the file are behind the elements. */
    boolean hasBytes() {
        return view != null;
    }

    int count() {
        return count;
    }

    int components() {
        return components;
    }

    ComponentType type() {
        return type;
    }

    boolean isNormalized() {
        return normalized && type != ComponentType.FLOAT;
    }

    /** The channel that jSM wrote the values from, or null. */
    KeptChannel kept() {
        return kept;
    }

    /** The bits of a component as a channel of its type holds them. */
    int raw(int element, int component) {
        int at = sparse == null ? -1 : sparse.place(element);
        if (at >= 0) return type.raw(sparse.values(), at + component * type.bytes());
        return view == null ? 0 : type.raw(view, start + element * step + component * type.bytes());
    }

    /** An unsigned integer, negative when it is above 2³¹. */
    int index(int element) throws IOException {
        if (type == ComponentType.FLOAT || components != 1) throw document.error(name + " are no indices");
        return raw(element, 0);
    }

    /** The number: integers as they are, or as a part of their largest when normalized. */
    double number(int element, int component) {
        return type.number(raw(element, component), normalized);
    }

    /** A number that must be finite. */
    double finite(int element, int component) throws IOException {
        double number = number(element, component);
        if (Double.isFinite(number)) return number;
        throw document.error(
                name + " has " + number + " at element " + element + ", not a finite number",
                "Repair or remove this vertex");
    }

    /** Are all components of an element finite? */
    boolean isFinite(int element) {
        for (int c = 0; c < components; c++) if (!Double.isFinite(number(element, c))) return false;
        return true;
    }
}
