package org.jsmesh.files.gltf.read;

import java.io.IOException;

/** The triangles of a primitive: lists, strips and fans, with or without indices. */
final class TriangleSource {
    static final int TRIANGLES = 4;
    private static final int TRIANGLE_STRIP = 5;
    private static final int TRIANGLE_FAN = 6;

    private final GltfDocument document;
    private final GltfAccessor indices; // or null
    private final int mode;
    private final int elements;
    private final int vertices;
    private final int[] triangle = new int[3];

    TriangleSource(GltfDocument document, int mode, GltfAccessor indices, int vertices) {
        this.document = document;
        this.mode = mode;
        this.indices = indices;
        this.vertices = vertices;
        elements = indices == null ? vertices : indices.count();
    }

    static boolean isOfTriangles(int mode) {
        return mode >= TRIANGLES && mode <= TRIANGLE_FAN;
    }

    /** Degenerate triangles of strips and fans included. */
    int count() {
        return mode == TRIANGLES ? elements / 3 : Math.max(0, elements - 2);
    }

    /** Without the degenerate triangles of a strip. */
    int faces() throws IOException {
        if (mode != TRIANGLE_STRIP) return count();
        int faces = 0;
        for (int t = 0; t < count(); t++) if (triangle(t) != null) faces++;
        return faces;
    }

    /** Whether corners are left that make no whole triangle. */
    boolean hasRest() {
        return mode == TRIANGLES && elements % 3 != 0;
    }

    /**
     * Vertices of a triangle, or null when it is the degenerate stitching of a strip. The next call reuses the array.
     */
    int[] triangle(int t) throws IOException {
        boolean list = mode == TRIANGLES;
        boolean odd = mode == TRIANGLE_STRIP && (t & 1) != 0;
        triangle[0] = vertex(list ? 3 * t : mode == TRIANGLE_FAN ? 0 : odd ? t + 1 : t);
        triangle[1] = vertex(list ? 3 * t + 1 : odd ? t : t + 1);
        triangle[2] = vertex(list ? 3 * t + 2 : t + 2);
        boolean degenerate = triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[0] == triangle[2];
        return degenerate && mode == TRIANGLE_STRIP ? null : triangle;
    }

    private int vertex(int element) throws IOException {
        int vertex = indices == null ? element : indices.index(element);
        if (vertex < 0 || vertex >= vertices)
            throw document.error("an index names vertex " + Integer.toUnsignedString(vertex) + " of " + vertices);
        return vertex;
    }
}
