package org.jsmesh.display;

import java.util.Arrays;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/** Makes the arrays of a {@link RenderMesh} from a mesh. */
final class RenderMeshBuilder {
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
        if (given != null && !given.hasAbsent()) takeNormals(given);
        else computeNormals();
        DisplaySlots slots = DisplaySlots.of(mesh.materials(), colour != null);
        int[] groups = slots.groups(mesh.faceMaterials());
        int[] indices = indices(slots.firstIndices(mesh.faceMaterials(), groups));
        return new RenderMesh(positions(), normals, textureCoordinates(), colours(), indices, groups, slots);
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
            while (v >= 0 && next[v] != -2 && !computed.equal(c, normals, v)) {
                last = v;
                v = next[v];
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

    private float[] textureCoordinates() {
        Channel uv = mesh.channel(Channel.Semantic.TEXCOORD);
        if (uv == null || uv.components() < 2) return new float[0];
        float[] coordinates = new float[2 * vertices()];
        for (int i = 0; i < vertices(); i++) {
            coordinates[2 * i] = uv.number(wedge(i), 0);
            coordinates[2 * i + 1] = uv.number(wedge(i), 1);
        }
        return coordinates;
    }

    private int[] colours() {
        if (colour == null) return new int[0];
        int[] packed = new int[vertices()];
        // One component is a shade of grey.
        int green = Math.min(1, colour.components() - 1);
        int blue = Math.min(2, colour.components() - 1);
        for (int i = 0; i < packed.length; i++) {
            int w = wedge(i);
            int alpha = colour.components() > 3 ? level(w, 3) : 255;
            packed[i] =
                    colour.isAbsent(w) ? -1 : level(w, 0) | level(w, green) << 8 | level(w, blue) << 16 | alpha << 24;
        }
        return packed;
    }

    private int level(int wedge, int component) {
        double value = colour.number(wedge, component);
        return value <= 0 ? 0 : value >= 1 ? 255 : (int) (value * 255 + .5);
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
