package org.jsmesh.mesh.io;

import java.util.Arrays;
import org.jsmesh.mesh.Channel;

/** One attribute of a {@code .m} file: rows of values, and the row that each vertex and each corner names. */
final class HoppeAttribute {
    private final Channel.Semantic semantic;
    private final String name;
    private final String key;
    private final int components;
    private final IntList rows = new IntList();
    private final IntList vertexRows = new IntList();
    private final IntList cornerRows = new IntList();

    HoppeAttribute(Channel.Semantic semantic, String name, String key, int components) {
        this.semantic = semantic;
        this.name = name;
        this.key = key;
        this.components = components;
    }

    String key() {
        return key;
    }

    int components() {
        return components;
    }

    boolean isUsed() {
        return rows.size() > 0;
    }

    /** @param values or null */
    void ofVertex(int vertex, float[] values) {
        if (values != null) set(vertexRows, vertex, values);
    }

    /** @param values or null */
    void ofCorner(int corner, float[] values) {
        if (values != null) set(cornerRows, corner, values);
    }

    private void set(IntList list, int index, float[] values) {
        while (list.size() <= index) list.add(-1);
        list.set(index, rows.size() / components);
        for (float value : values) rows.add(Float.floatToRawIntBits(value));
    }

    CornerAttribute attribute(PolygonList polygons) {
        int[] corners = new int[polygons.corners()];
        Arrays.fill(corners, -1);
        for (int c = 0; c < corners.length; c++) {
            int own = c < cornerRows.size() ? cornerRows.get(c) : -1;
            int vertex = polygons.vertex(c);
            corners[c] = own >= 0 ? own : vertex < vertexRows.size() ? vertexRows.get(vertex) : -1;
        }
        return new CornerAttribute(semantic, name, components, Channel.Type.FLOAT32, rows.toArray(), corners);
    }
}
