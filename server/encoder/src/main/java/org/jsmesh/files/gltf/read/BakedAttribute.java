package org.jsmesh.files.gltf.read;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.jsmesh.files.gltf.json.AttributeNames;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.CornerAttribute;

/** One attribute of all baked vertices; vertices of primitives without it have none. */
final class BakedAttribute {
    private final GltfDocument document;
    private final String name;
    private final Channel.Semantic semantic;
    private final int order;
    private StoredType stored; // null until the first accessor
    private int components;
    private int[] rows = new int[64];
    private int rowCount;
    private int[] vertexRows = new int[64];
    private int vertexCount;
    private int spoilt;
    private String firstSpoilt;

    /** @param kept what the extras say of the channel; null where they say nothing */
    BakedAttribute(GltfDocument document, String name, KeptChannel kept) {
        this.document = document;
        this.name = name;
        order = kept == null ? Integer.MAX_VALUE : kept.order();
        if (kept != null) semantic = kept.semantic();
        else if (name.equals("NORMAL")) semantic = Channel.Semantic.NORMAL;
        else if (name.startsWith("TEXCOORD_")) semantic = Channel.Semantic.TEXCOORD;
        else if (name.startsWith("COLOR_")) semantic = Channel.Semantic.COLOUR;
        else semantic = Channel.Semantic.CUSTOM;
    }

    /** Whether an attribute of a primitive is kept. */
    static boolean isKept(String name) {
        return AttributeNames.isKnown(name);
    }

    /** Can the channel hold such values beside those that it has? */
    boolean fits(GltfAccessor accessor) {
        int given = accessor.components();
        if (accessor.kept() != null) return stored == null || given == components;
        return switch (semantic) {
            case NORMAL -> given == 3;
            case TEXCOORD -> given == 2;
            case COLOUR -> given == 3 || given == 4;
            case CUSTOM -> name.startsWith("_") ? stored == null || given == components : given == 4;
        };
    }

    /** Makes room for the values of an accessor. Types and components that differ become ones that hold them all. */
    void admit(GltfAccessor accessor, Transform transform) {
        components = Math.max(components, accessor.components());
        StoredType type = type(accessor, transform);
        stored = stored == null ? type : stored.with(type);
    }

    /**
     * Whole numbers that viewers take as parts of their largest stay as they are; so do those of attributes that they
     * do not know. What a transform turns has other values.
     */
    private StoredType type(GltfAccessor accessor, Transform transform) {
        if (accessor.kept() != null) {
            boolean turned = semantic == Channel.Semantic.NORMAL && !transform.keepsDirections();
            return turned ? StoredType.FLOATS : new StoredType(accessor.kept().type(), false);
        }
        StoredType type = StoredType.of(accessor);
        boolean signed = accessor.type() == ComponentType.BYTE || accessor.type() == ComponentType.SHORT;
        boolean small = accessor.type() != ComponentType.UNSIGNED_INT;
        boolean stays = switch (semantic) {
            case NORMAL -> signed && accessor.isNormalized() && transform.keepsDirections();
            case TEXCOORD, COLOUR -> small && accessor.isNormalized();
            case CUSTOM -> !isTangent();
        };
        return stays ? type : StoredType.FLOATS;
    }

    private boolean isTangent() {
        return name.equals("TANGENT");
    }

    void add(int vertex, GltfAccessor accessor, int element, Transform transform) throws IOException {
        if (vertex >= vertexRows.length)
            vertexRows = Arrays.copyOf(vertexRows, Math.max(vertex + 1, 2 * vertexRows.length));
        Arrays.fill(vertexRows, vertexCount, vertex + 1, -1);
        vertexCount = vertex + 1;
        if (!accessor.isFinite(element)) {
            if (spoilt++ == 0) firstSpoilt = "vertex " + element;
            return;
        }
        vertexRows[vertex] = rowCount;
        int words = components * stored.type().words();
        int at = rowCount++ * words;
        if (at + words > rows.length) rows = Arrays.copyOf(rows, 2 * (at + words));
        boolean asItIs = accessor.kept() == null && stored.equals(StoredType.of(accessor));
        boolean turned = (isTangent() || semantic == Channel.Semantic.NORMAL) && !transform.keepsDirections();
        if (turned) {
            turn(at, accessor, element, transform);
            return;
        }
        for (int c = 0; c < components; c++, at += stored.type().words()) {
            if (c >= accessor.components()) stored.put(opaque(), rows, at);
            else if (asItIs) rows[at] = accessor.raw(element, c);
            else stored.put(number(accessor, element, c), rows, at);
        }
    }

    private static double number(GltfAccessor accessor, int element, int component) {
        KeptChannel kept = accessor.kept();
        return kept == null
                ? accessor.number(element, component)
                : kept.number(accessor.type().number(accessor.raw(element, component), false), component);
    }

    /** The opacity of colours that have none among ones that do. */
    private double opaque() {
        return switch (stored.type()) {
            case UINT8 -> 255;
            case UINT16 -> 65535;
            default -> 1;
        };
    }

    private void turn(int at, GltfAccessor accessor, int element, Transform transform) throws IOException {
        float[] values = new float[components];
        for (int c = 0; c < components; c++) values[c] = (float) accessor.number(element, c);
        if (isTangent()) transform.tangent(values);
        else transform.normal(values);
        if (Float.isNaN(values[0] + values[1] + values[2]))
            throw document.error("the transform of a node is beyond the range of numbers", "Scale the scene down");
        int words = stored.type().words();
        for (int c = 0; c < components; c++) stored.put(values[c], rows, at + c * words);
    }

    /** Place among the attributes; the largest number for those that have none. */
    int order() {
        return order;
    }

    Channel.Semantic semantic() {
        return semantic;
    }

    void report(List<Note> notes) {
        if (spoilt == 0) return;
        String text = "The " + name + " of " + (spoilt == 1 ? "1 vertex" : spoilt + " vertices")
                + " left out: not finite numbers.";
        Note note = Note.dropped(text, spoilt, firstSpoilt);
        notes.add(semantic == Channel.Semantic.CUSTOM ? note : note.asWarning());
    }

    /** @param taken names of other channels; gets that of this one */
    CornerAttribute attribute(int[] cornerVertices, Set<String> taken) {
        int[] cornerRows = new int[cornerVertices.length];
        for (int i = 0; i < cornerRows.length; i++)
            cornerRows[i] = cornerVertices[i] < vertexCount ? vertexRows[cornerVertices[i]] : -1;
        String unique = semantic == Channel.Semantic.CUSTOM && stored.normalized() ? name + " normalized" : name;
        while (!taken.add(unique)) unique += "'";
        int words = components * stored.type().words();
        return new CornerAttribute(
                semantic, unique, components, stored.type(), Arrays.copyOf(rows, rowCount * words), cornerRows);
    }
}
