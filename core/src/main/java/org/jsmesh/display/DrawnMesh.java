package org.jsmesh.display;

import java.util.Arrays;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/**
 * Makes the arrays for a graphics card from a mesh. A render vertex is a wedge; where a model without normals has a
 * crease, a wedge has one render vertex for each side of it. The first render vertex of wedge {@code w} has the number
 * {@code w}, so numbers stay as a mesh is refined; those that creases add follow after the wedges.
 */
public final class DrawnMesh {
    private final Mesh mesh;
    private final DisplaySlots slots;
    private final double creaseCosine;
    private final Channel normalChannel;

    /** Render vertex of each corner. */
    private int[] cornerVertices;

    private int[] vertexWedges;
    private float[] normals;

    /** @param creaseCosine cosine of the angle between faces from which on an edge is a crease */
    public DrawnMesh(Mesh mesh, DisplaySlots slots, double creaseCosine) {
        this.mesh = mesh;
        this.slots = slots;
        this.creaseCosine = creaseCosine;
        this.normalChannel = threeComponents(mesh.channel(Channel.Semantic.NORMAL));
    }

    public DrawnArrays arrays() {
        if (normalChannel != null && !normalChannel.hasAbsent()) takeNormals();
        else computeNormals();
        int[] groups = new int[3 * slots.size()];
        int[] indices = indicesBySlot(groups);
        return new DrawnArrays(positions(), normals, textureCoordinates(), colours(), indices, groups);
    }

    private void takeNormals() {
        cornerVertices = mesh.faceWedges();
        vertexWedges = null;
        normals = new float[3 * mesh.wedges()];
        int[] values = normalChannel.values();
        boolean floats = normalChannel.type() == Channel.Type.FLOAT32;
        for (int i = 0; i < normals.length; i++)
            normals[i] = floats ? Float.intBitsToFloat(values[i]) : values[i] / 127.5f - 1;
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
        Channel colour = mesh.channel(Channel.Semantic.COLOUR);
        if (colour == null || colour.components() < 3) return new int[0];
        int[] packed = new int[vertices()];
        for (int i = 0; i < packed.length; i++) {
            int w = wedge(i);
            int alpha = colour.components() > 3 ? level(colour, w, 3) : 255;
            packed[i] = colour.isAbsent(w)
                    ? -1
                    : level(colour, w, 0) | level(colour, w, 1) << 8 | level(colour, w, 2) << 16 | alpha << 24;
        }
        return packed;
    }

    private static int level(Channel colour, int wedge, int component) {
        float value = colour.number(wedge, component);
        return value <= 0 ? 0 : value >= 1 ? 255 : (int) (value * 255 + .5f);
    }

    /** Faces sorted by display slot (a counting sort, so their order within a slot stays). */
    private int[] indicesBySlot(int[] groups) {
        int[] materials = mesh.faceMaterials();
        for (int material : materials) groups[3 * slots.slot(material) + 2] += 3;
        int start = 0;
        int[] at = new int[slots.size()];
        for (int s = 0; s < at.length; s++) {
            groups[3 * s] = s;
            groups[3 * s + 1] = at[s] = start;
            start += groups[3 * s + 2];
        }
        int[] indices = new int[cornerVertices.length];
        for (int f = 0; f < materials.length; f++) {
            int slot = slots.slot(materials[f]);
            int to = at[slot];
            indices[to] = cornerVertices[3 * f];
            indices[to + 1] = cornerVertices[3 * f + 1];
            indices[to + 2] = cornerVertices[3 * f + 2];
            at[slot] = to + 3;
        }
        return indices;
    }

    private static Channel threeComponents(Channel normal) {
        return normal != null && normal.components() == 3 ? normal : null;
    }
}
