package org.jsmesh.desktop;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;

/**
 * A mesh as vertex arrays for a graphics card, without any OpenGL: one vertex per wedge, faces sorted by material.
 * Immutable; arrays are shared.
 *
 * @param positions x, y, z per wedge in the unit space of {@link Framing}
 * @param normals x, y, z per wedge, of the file where it has them, else {@link SmoothNormals}
 * @param texCoords u, v per wedge, or null when no material in use has a texture or no wedge has coordinates
 * @param colours red, green, blue, 255 per wedge, or null when the mesh has no vertex colours
 * @param indices three wedges per face, grouped by material
 * @param groups what to draw with which material, opaque ones first
 */
record RenderMesh(
        float[] positions, float[] normals, float[] texCoords, byte[] colours, int[] indices, List<Group> groups) {
    /**
     * Faces with the same material.
     *
     * @param first index into {@code indices}
     * @param count of indices
     */
    record Group(Surface surface, int first, int count) {}

    int vertices() {
        return positions.length / 3;
    }

    int faces() {
        return indices.length / 3;
    }

    static RenderMesh of(Mesh mesh, Framing framing) {
        float[] unit = framing.toUnit(mesh.positions());
        Channel colour = mesh.channel(Channel.Semantic.COLOUR);
        int[] starts = materialStarts(mesh);
        List<Group> groups = groups(mesh, starts, colour != null);
        boolean textured = groups.stream().anyMatch(g -> g.surface().texture() != null);
        Channel uv = textured ? mesh.channel(Channel.Semantic.TEXCOORD) : null;
        return new RenderMesh(
                perWedge(mesh, unit),
                normals(mesh, unit),
                uv == null || uv.components() < 2 ? null : numbers(uv, 2),
                colour == null ? null : bytes(colour),
                indices(mesh, starts),
                groups);
    }

    /**
     * Where the faces of each material start when sorted; entry 0 is for faces without material, the last is the number
     * of faces.
     */
    private static int[] materialStarts(Mesh mesh) {
        int[] starts = new int[mesh.materials().size() + 2];
        for (int m : mesh.faceMaterials()) starts[m + 2]++;
        for (int i = 1; i < starts.length; i++) starts[i] += starts[i - 1];
        return starts;
    }

    private static List<Group> groups(Mesh mesh, int[] starts, boolean vertexColours) {
        List<Group> opaque = new ArrayList<>();
        List<Group> translucent = new ArrayList<>();
        for (int i = 0; i + 1 < starts.length; i++) {
            if (starts[i] == starts[i + 1]) continue;
            Material material = i == 0 ? null : mesh.materials().get(i - 1);
            Surface surface = Surface.of(material, vertexColours);
            Group group = new Group(surface, 3 * starts[i], 3 * (starts[i + 1] - starts[i]));
            (surface.isOpaque() ? opaque : translucent).add(group);
        }
        opaque.addAll(translucent);
        return List.copyOf(opaque);
    }

    private static int[] indices(Mesh mesh, int[] starts) {
        int[] next = starts.clone();
        int[] wedges = mesh.faceWedges();
        int[] sorted = new int[wedges.length];
        for (int f = 0; f < mesh.faces(); f++) {
            int to = 3 * next[mesh.faceMaterials()[f] + 1]++;
            System.arraycopy(wedges, 3 * f, sorted, to, 3);
        }
        return sorted;
    }

    private static float[] normals(Mesh mesh, float[] unit) {
        Channel channel = mesh.channel(Channel.Semantic.NORMAL);
        boolean given = channel != null && channel.components() == 3;
        float[] normals = given && !channel.hasAbsent()
                ? new float[3 * mesh.wedges()]
                : perWedge(mesh, SmoothNormals.of(mesh, unit));
        if (!given) return normals;
        for (int w = 0; w < mesh.wedges(); w++) {
            if (channel.isAbsent(w)) continue;
            for (int k = 0; k < 3; k++) normals[3 * w + k] = channel.number(w, k);
        }
        return normals;
    }

    private static float[] perWedge(Mesh mesh, float[] perVertex) {
        int[] vertices = mesh.wedgeVertices();
        float[] values = new float[3 * vertices.length];
        for (int w = 0; w < vertices.length; w++) System.arraycopy(perVertex, 3 * vertices[w], values, 3 * w, 3);
        return values;
    }

    private static float[] numbers(Channel channel, int components) {
        float[] values = new float[components * channel.wedges()];
        for (int w = 0; w < channel.wedges(); w++) {
            for (int k = 0; k < components; k++) values[components * w + k] = channel.number(w, k);
        }
        return values;
    }

    private static byte[] bytes(Channel colour) {
        int given = Math.min(3, colour.components());
        byte[] values = new byte[4 * colour.wedges()];
        for (int w = 0; w < colour.wedges(); w++) {
            for (int k = 0; k < 3; k++) {
                // A wedge without colour is white: the material shows as it is. One component is a shade of grey.
                float value = colour.isAbsent(w) ? 1 : colour.number(w, Math.min(k, given - 1));
                values[4 * w + k] = (byte) Math.round(255 * Math.max(0, Math.min(1, value)));
            }
            values[4 * w + 3] = (byte) 255;
        }
        return values;
    }
}
