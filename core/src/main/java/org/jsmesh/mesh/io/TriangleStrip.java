package org.jsmesh.mesh.io;

/** Unrolls triangle strips. Every second triangle is turned. Degenerate triangles only join strips and are dropped. */
final class TriangleStrip {
    private final PolygonList out;
    private int first;
    private int second;
    private int length;
    private int dropped;

    TriangleStrip(PolygonList out) {
        this.out = out;
    }

    /** The next vertex of the strip; −1 ends it. */
    void add(int vertex) {
        if (vertex < 0) {
            length = 0;
            return;
        }
        if (length >= 2) triangle(length % 2 == 0 ? first : second, length % 2 == 0 ? second : first, vertex);
        first = second;
        second = vertex;
        length++;
    }

    int dropped() {
        return dropped;
    }

    private void triangle(int a, int b, int c) {
        if (a == b || b == c || a == c) {
            dropped++;
            return;
        }
        out.corner(a);
        out.corner(b);
        out.corner(c);
        out.end(-1);
    }
}
