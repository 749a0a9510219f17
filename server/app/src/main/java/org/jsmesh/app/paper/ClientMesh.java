package org.jsmesh.app.paper;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/**
 * Connectivity as a client of the paper has it (section 5.1): faces with their vertices, wedges and material, to which
 * vertex splits append. Ids count from 0 in the order in which they come. Every directed edge has at most one face.
 */
final class ClientMesh {
    private final Map<Long, Integer> faceOfEdge = new HashMap<>();
    private int[] corners = new int[3 * 256]; // vertex of each corner
    private int[] wedges = new int[3 * 256];
    private int[] materials = new int[256];
    private int faces;

    int faces() {
        return faces;
    }

    int vertex(int face, int corner) {
        return corners[3 * face + corner];
    }

    int wedge(int face, int corner) {
        return wedges[3 * face + corner];
    }

    int material(int face) {
        return materials[face];
    }

    /** Appends a face; vertices and wedges of its corners. */
    void add(int[] face, int[] faceWedges, int material) {
        if (faces == materials.length) {
            corners = Arrays.copyOf(corners, 6 * faces);
            wedges = Arrays.copyOf(wedges, 6 * faces);
            materials = Arrays.copyOf(materials, 2 * faces);
        }
        System.arraycopy(face, 0, corners, 3 * faces, 3);
        System.arraycopy(faceWedges, 0, wedges, 3 * faces, 3);
        materials[faces] = material;
        for (int k = 0; k < 3; k++) faceOfEdge.put(edge(face[k], face[(k + 1) % 3]), faces);
        faces++;
    }

    /** The corner of a face that has this vertex. */
    int cornerOf(int face, int vertex) {
        for (int k = 0; k < 3; k++) if (vertex(face, k) == vertex) return k;
        throw new IllegalArgumentException("face " + face + " has no vertex " + vertex);
    }

    /**
     * Splits a vertex (figure 5 of the paper). The new vertex gets its faces from the first one on, so many,
     * counter-clockwise; two faces come between it and the vertex that is split.
     *
     * @param first face f_t
     * @param corner of it at the vertex v_t that is split
     * @param count of faces from f_t to f_r
     * @param vertex v_s, the new one
     * @param wedge of it
     */
    void split(int first, int corner, int count, int vertex, int wedge) {
        int v = vertex(first, corner);
        int kept = wedge(first, corner);
        int[] left = {vertex, v, vertex(first, (corner + 1) % 3)};
        int[] leftWedges = {wedge, kept, wedge(first, (corner + 1) % 3)};
        int[] right = {vertex, -1, v};
        int[] rightWedges = {wedge, -1, kept};
        int face = first;
        for (int i = 0; i < count; i++) {
            int k = cornerOf(face, v);
            int a = vertex(face, (k + 1) % 3);
            int b = vertex(face, (k + 2) % 3);
            Integer next = faceOfEdge.get(edge(v, b));
            faceOfEdge.remove(edge(v, a));
            faceOfEdge.remove(edge(b, v));
            corners[3 * face + k] = vertex;
            wedges[3 * face + k] = wedge;
            faceOfEdge.put(edge(vertex, a), face);
            faceOfEdge.put(edge(b, vertex), face);
            right[1] = b;
            rightWedges[1] = wedge(face, (k + 2) % 3);
            if (i + 1 == count) break;
            if (next == null) throw new IllegalArgumentException("vertex " + v + " has no " + count + " faces");
            face = next;
        }
        int material = material(first);
        add(left, leftWedges, material);
        add(right, rightWedges, material);
    }

    private static long edge(int from, int to) {
        return (long) from << 32 | to;
    }
}
