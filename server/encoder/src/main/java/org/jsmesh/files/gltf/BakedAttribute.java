package org.jsmesh.files.gltf;

import java.io.IOException;
import java.util.Arrays;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.io.CornerAttribute;

/** One attribute of all baked vertices; vertices of primitives without it have none. */
final class BakedAttribute {
    private final GltfDocument document;
    private final String gltfName;
    private final Channel.Semantic semantic;
    private final String name;
    private boolean bytes = true;
    private int components;
    private int[] rows = new int[64];
    private int rowCount;
    private int[] vertexRows = new int[64];
    private int vertexCount;

    BakedAttribute(GltfDocument document, String gltfName) {
        this.document = document;
        this.gltfName = gltfName;
        if (gltfName.equals("NORMAL")) {
            semantic = Channel.Semantic.NORMAL;
            name = "normal";
        } else {
            boolean texcoord = gltfName.startsWith("TEXCOORD_");
            semantic = texcoord ? Channel.Semantic.TEXCOORD : Channel.Semantic.COLOUR;
            String number = gltfName.substring(gltfName.indexOf('_') + 1);
            name = (texcoord ? "uv" : "colour") + (number.equals("0") ? "" : number);
        }
    }

    /** Whether an attribute of a primitive is kept. */
    static boolean isKept(String gltfName) {
        return gltfName.equals("NORMAL") || gltfName.matches("(TEXCOORD|COLOR)_[0-9]{1,3}");
    }

    /**
     * Makes room for the values of an accessor: colours are bytes with or without alpha only when all primitives agree.
     */
    void admit(GltfAccessor accessor) throws IOException {
        int given = accessor.components();
        boolean fits = semantic == Channel.Semantic.COLOUR
                ? given == 3 || given == 4
                : given == (semantic == Channel.Semantic.NORMAL ? 3 : 2);
        if (!fits) throw document.error(gltfName + " has " + given + " components");
        components = Math.max(components, given);
        bytes = bytes && semantic == Channel.Semantic.COLOUR && accessor.isByteFraction();
    }

    void add(int vertex, GltfAccessor accessor, int element, Transform transform) throws IOException {
        if (vertex >= vertexRows.length)
            vertexRows = Arrays.copyOf(vertexRows, Math.max(vertex + 1, 2 * vertexRows.length));
        Arrays.fill(vertexRows, vertexCount, vertex, -1);
        vertexRows[vertex] = rowCount;
        vertexCount = vertex + 1;
        int at = rowCount++ * components;
        if (at + components > rows.length) rows = Arrays.copyOf(rows, 2 * (at + components));
        if (bytes) {
            for (int c = 0; c < components; c++)
                rows[at + c] = c < accessor.components() ? accessor.raw(element, c) : 255;
            return;
        }
        float[] values = new float[components];
        for (int c = 0; c < components; c++) values[c] = c < accessor.components() ? accessor.number(element, c) : 1f;
        if (semantic == Channel.Semantic.NORMAL) {
            transform.normal(values);
            if (Float.isNaN(values[0] + values[1] + values[2])) {
                throw document.error("the transform of a node is beyond the range of numbers", "Scale the scene down");
            }
        }
        for (int c = 0; c < components; c++) rows[at + c] = Float.floatToRawIntBits(values[c]);
    }

    CornerAttribute attribute(int[] cornerVertices) {
        int[] cornerRows = new int[cornerVertices.length];
        for (int i = 0; i < cornerRows.length; i++)
            cornerRows[i] = cornerVertices[i] < vertexCount ? vertexRows[cornerVertices[i]] : -1;
        Channel.Type type = bytes ? Channel.Type.UINT8 : Channel.Type.FLOAT32;
        return new CornerAttribute(
                semantic, name, components, type, Arrays.copyOf(rows, rowCount * components), cornerRows);
    }
}
