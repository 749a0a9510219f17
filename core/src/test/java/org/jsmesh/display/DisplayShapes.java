package org.jsmesh.display;

import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/** Meshes without normals. */
final class DisplayShapes {
    private DisplayShapes() {}

    /** From −1 to 1, a vertex per corner, two faces per side: −x, x, −y, y, −z, z. */
    static Mesh cube() {
        float[] positions = new float[24];
        for (int i = 0; i < 24; i++) positions[i] = (i / 3 >> i % 3 & 1) == 0 ? -1 : 1;
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(new int[] {
                    0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7,
                    4, 7, 6
                })
                .build();
    }

    static Mesh coloured(Mesh mesh) {
        int[] values = new int[3 * mesh.wedges()];
        for (int i = 0; i < values.length; i++) values[i] = 10 * i;
        return MeshBuilder.from(mesh)
                .channels(List.of(new Channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.UINT8, values, null)))
                .build();
    }

    /** Around the z axis, radius 1; the poles are the first vertex and the last. */
    static Mesh sphere(int rings, int around) {
        int last = (rings - 1) * around + 1;
        float[] positions = new float[3 * (last + 1)];
        positions[2] = 1;
        positions[3 * last + 2] = -1;
        int[] faces = new int[6 * around * (rings - 1)];
        int at = 0;
        for (int v = 1; v < last; v++) {
            double down = Math.PI * (1 + (v - 1) / around) / rings;
            double turn = 2 * Math.PI * ((v - 1) % around) / around;
            positions[3 * v] = (float) (Math.sin(down) * Math.cos(turn));
            positions[3 * v + 1] = (float) (Math.sin(down) * Math.sin(turn));
            positions[3 * v + 2] = (float) Math.cos(down);
            int right = v % around == 0 ? v - around + 1 : v + 1;
            int above = Math.max(0, v - around);
            int below = Math.min(last, v + around);
            int belowRight = Math.min(last, right + around);
            int[] pair = {v, below, belowRight, v, belowRight, right};
            if (v <= around) at = add(faces, at, above, v, right);
            at = below == last ? add(faces, at, v, last, right) : add(faces, at, pair);
        }
        return new MeshBuilder().positions(positions).faceWedges(faces).build();
    }

    private static int add(int[] faces, int at, int... corners) {
        System.arraycopy(corners, 0, faces, at, corners.length);
        return at + corners.length;
    }

    /** Its tip is the first vertex, at the origin; steep sides that look upwards by 45°. */
    static Mesh cone(int faces) {
        float[] positions = new float[3 * (faces + 1)];
        int[] corners = new int[3 * faces];
        for (int i = 1; i <= faces; i++) {
            positions[3 * i] = (float) Math.cos(2 * Math.PI * i / faces);
            positions[3 * i + 1] = (float) Math.sin(2 * Math.PI * i / faces);
            positions[3 * i + 2] = -1;
            add(corners, 3 * (i - 1), 0, i, i == faces ? 1 : i + 1);
        }
        return new MeshBuilder().positions(positions).faceWedges(corners).build();
    }
}
