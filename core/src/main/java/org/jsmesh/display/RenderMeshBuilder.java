package org.jsmesh.display;

import java.util.Arrays;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/** Makes the arrays of a {@link RenderMesh} from a mesh. */
final class RenderMeshBuilder {
    /** Vertices of a wedge that a corner is compared with: a flat cone has as many normals at its tip as faces. */
    private static final int MOST_COMPARED = 64;

    private final Mesh mesh;
    private final double creaseCosine;
    private final Channel colour;

    /** Render vertex of each corner. */
    private int[] cornerVertices;

    /** Wedge of each render vertex, or null when they have the same numbers. */
    private int[] vertexWedges;

    private float[] normals;

    RenderMeshBuilder(Mesh mesh, double creaseCosine) {
        this.mesh = mesh;
        this.creaseCosine = creaseCosine;
        this.colour = mesh.channel(Channel.Semantic.COLOUR);
    }

    RenderMesh build() {
        Channel given = CornerNormals.given(mesh);
        if (given != null && isWhole(given)) takeNormals(given);
        else computeNormals();
        DisplaySlots slots = DisplaySlots.of(mesh.materials(), colour != null);
        int[] groups = slots.groups(mesh.faceMaterials());
        int[] indices = indices(slots.firstIndices(mesh.faceMaterials(), groups));
        return new RenderMesh(
                positions(), normals, tangents(), textureCoordinates(), colours(), indices, groups, slots);
    }

    private static boolean isWhole(Channel given) {
        for (int w = 0; w < given.wedges(); w++) if (!CornerNormals.isThere(given, w)) return false;
        return true;
    }

    private void takeNormals(Channel given) {
        cornerVertices = mesh.faceWedges();
        vertexWedges = null;
        normals = new float[3 * mesh.wedges()];
        for (int w = 0; w < mesh.wedges(); w++) CornerNormals.put(given, w, normals, w);
    }

    private void computeNormals() {
        CornerNormals computed = new CornerNormals(mesh, creaseCosine);
        int wedges = mesh.wedges();
        int[] corners = mesh.faceWedges();
        cornerVertices = new int[corners.length];
        vertexWedges = new int[wedges];
        normals = new float[3 * wedges];
        // Render vertices of a wedge are chained; −2 marks a wedge that no corner has used yet.
        int[] next = new int[wedges];
        Arrays.fill(next, -2);
        int count = wedges;
        for (int w = 0; w < wedges; w++) vertexWedges[w] = w;
        for (int c = 0; c < corners.length; c++) {
            int v = corners[c];
            int last = v;
            int left = MOST_COMPARED;
            while (v >= 0 && next[v] != -2 && !computed.equal(c, normals, v)) {
                last = v;
                v = left-- > 0 ? next[v] : -1;
            }
            if (v < 0) {
                v = count++;
                if (v == vertexWedges.length) {
                    int size = v + v / 4 + 16;
                    vertexWedges = Arrays.copyOf(vertexWedges, size);
                    next = Arrays.copyOf(next, size);
                    normals = Arrays.copyOf(normals, 3 * size);
                }
                vertexWedges[v] = corners[c];
                next[last] = v;
                next[v] = -2;
            }
            if (next[v] == -2) {
                next[v] = -1;
                computed.copy(c, normals, v);
            }
            cornerVertices[c] = v;
        }
        vertexWedges = Arrays.copyOf(vertexWedges, count);
        normals = Arrays.copyOf(normals, 3 * count);
    }

    private int vertices() {
        return normals.length / 3;
    }

    private int wedge(int vertex) {
        return vertexWedges == null ? vertex : vertexWedges[vertex];
    }

    private float[] positions() {
        float[] of = mesh.positions();
        int[] wedgeVertices = mesh.wedgeVertices();
        float[] positions = new float[normals.length];
        for (int i = 0; i < vertices(); i++) {
            int from = 3 * wedgeVertices[wedge(i)];
            positions[3 * i] = of[from];
            positions[3 * i + 1] = of[from + 1];
            positions[3 * i + 2] = of[from + 2];
        }
        return positions;
    }

    private float[][] textureCoordinates() {
        Channel[] channels = RenderMesh.textureSets(mesh);
        float[][] sets = new float[channels.length][];
        for (int i = 0; i < sets.length; i++) sets[i] = channels[i] == null ? new float[0] : numbers(channels[i], 2);
        return sets;
    }

    private float[] tangents() {
        for (Channel c : mesh.channels()) if (areTangents(c)) return numbers(c, 4);
        return new float[0];
    }

    static boolean areTangents(Channel c) {
        boolean usable = c.name().equals(RenderMesh.TANGENT) && c.components() == 4;
        return usable && c.type() == Channel.Type.FLOAT32;
    }

    private float[] numbers(Channel channel, int components) {
        float[] numbers = new float[components * vertices()];
        for (int i = 0; i < vertices(); i++) {
            if (channel.isAbsent(wedge(i))) continue;
            for (int k = 0; k < components; k++) numbers[components * i + k] = channel.number(wedge(i), k);
        }
        return numbers;
    }

    private int[] colours() {
        if (colour == null) return new int[0];
        int[] packed = new int[vertices()];
        double full = ColourRange.full(colour);
        for (int i = 0; i < packed.length; i++) {
            int w = wedge(i);
            packed[i] = colour.isAbsent(w) ? PackedColours.WHITE : PackedColours.of(colour, w, full);
        }
        return packed;
    }

    private int[] indices(int[] firstIndices) {
        int[] indices = new int[cornerVertices.length];
        for (int f = 0; f < firstIndices.length; f++) {
            int to = firstIndices[f];
            indices[to] = cornerVertices[3 * f];
            indices[to + 1] = cornerVertices[3 * f + 1];
            indices[to + 2] = cornerVertices[3 * f + 2];
        }
        return indices;
    }
}
