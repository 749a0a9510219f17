package org.jsmesh.samples;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * A binary little-endian PLY with a colour per vertex, made of parts. Coordinates have four decimals, as a modelling
 * program would export them.
 */
final class PlyBytes {
    private record Part(double[] positions, byte[] colours, int[] triangles, int firstVertex) {}

    private final List<Part> parts = new ArrayList<>();
    private int vertices;
    private int faces;

    /**
     * @param positions x, y, z of each vertex; {@code colours}: red, green, blue of each; {@code triangles}: three
     *     vertices of this part each
     */
    void add(double[] positions, byte[] colours, int[] triangles) {
        parts.add(new Part(positions, colours, triangles, vertices));
        vertices += positions.length / 3;
        faces += triangles.length / 3;
    }

    byte[] toBytes(String comment) {
        String header = String.join(
                "\n",
                "ply",
                "format binary_little_endian 1.0",
                "comment " + comment,
                "element vertex " + vertices,
                "property float x",
                "property float y",
                "property float z",
                "property uchar red",
                "property uchar green",
                "property uchar blue",
                "element face " + faces,
                "property list uchar int vertex_indices",
                "end_header",
                "");
        byte[] head = header.getBytes(StandardCharsets.US_ASCII);
        ByteBuffer out =
                ByteBuffer.allocate(head.length + 15 * vertices + 13 * faces).order(ByteOrder.LITTLE_ENDIAN);
        out.put(head);
        for (Part part : parts) {
            for (int v = 0; v < part.positions.length / 3; v++) {
                for (int axis = 0; axis < 3; axis++) {
                    out.putFloat((float) (StrictMath.rint(part.positions[3 * v + axis] * 1e4) / 1e4));
                }
                out.put(part.colours, 3 * v, 3);
            }
        }
        for (Part part : parts) {
            for (int corner = 0; corner < part.triangles.length; corner++) {
                if (corner % 3 == 0) out.put((byte) 3);
                out.putInt(part.firstVertex + part.triangles[corner]);
            }
        }
        return out.array();
    }
}
