package org.jsmesh.codec.lod;

import org.jsmesh.mesh.Mesh;

/** The faces about each vertex of a mesh, in order. */
public final class VertexFaces {
    private final int[] start;
    private final int[] faces;

    public VertexFaces(Mesh mesh) {
        start = new int[mesh.vertices() + 1];
        faces = new int[3 * mesh.faces()];
        for (int i = 0; i < faces.length; i++) start[mesh.vertex(i / 3, i % 3) + 1]++;
        for (int v = 0; v < mesh.vertices(); v++) start[v + 1] += start[v];
        int[] at = start.clone();
        for (int i = 0; i < faces.length; i++) faces[at[mesh.vertex(i / 3, i % 3)]++] = i / 3;
    }

    public int from(int vertex) {
        return start[vertex];
    }

    public int to(int vertex) {
        return start[vertex + 1];
    }

    public int face(int at) {
        return faces[at];
    }
}
