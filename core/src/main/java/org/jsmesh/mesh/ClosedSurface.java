package org.jsmesh.mesh;

import java.util.Arrays;

/**
 * Tells whether a mesh bounds a solid: nobody outside sees its faces from behind. Each edge has two faces, which run
 * along it in opposite directions, and each part of the mesh encloses a positive volume.
 */
public final class ClosedSurface {
    private ClosedSurface() {}

    /**
     * Looks at all faces.
     *
     * @param mesh with vertices that have places of their own
     * @return whether it is closed, and its faces look outwards
     */
    public static boolean is(Mesh mesh) {
        return mesh.faces() > 0 && hasPairs(mesh) && enclosesVolume(mesh);
    }

    /** Does each edge have one face on either side? Edges are kept with the smaller of their vertices. */
    private static boolean hasPairs(Mesh mesh) {
        int[] ends = new int[mesh.vertices() + 1];
        for (int f = 0; f < mesh.faces(); f++) {
            for (int k = 0; k < 3; k++) {
                int from = mesh.vertex(f, k);
                int to = mesh.vertex(f, (k + 1) % 3);
                if (from == to) return false;
                ends[Math.min(from, to) + 1]++;
            }
        }
        for (int v = 0; v < mesh.vertices(); v++) ends[v + 1] += ends[v];
        int[] at = ends.clone();
        int[] edges = new int[3 * mesh.faces()]; // the other vertex, and in the lowest bit the direction
        for (int f = 0; f < mesh.faces(); f++) {
            for (int k = 0; k < 3; k++) {
                int from = mesh.vertex(f, k);
                int to = mesh.vertex(f, (k + 1) % 3);
                edges[at[Math.min(from, to)]++] = Math.max(from, to) << 1 | (from < to ? 0 : 1);
            }
        }
        for (int v = 0; v < mesh.vertices(); v++) {
            if ((ends[v + 1] - ends[v]) % 2 != 0) return false;
            Arrays.sort(edges, ends[v], ends[v + 1]);
            for (int i = ends[v]; i < ends[v + 1]; i += 2) {
                if ((edges[i] & 1) != 0 || edges[i + 1] != edges[i] + 1) return false;
                if (i + 2 < ends[v + 1] && edges[i + 2] == edges[i]) return false;
            }
        }
        return true;
    }

    private static boolean enclosesVolume(Mesh mesh) {
        int[] part = new int[mesh.vertices()];
        for (int v = 0; v < part.length; v++) part[v] = v;
        for (int f = 0; f < mesh.faces(); f++)
            for (int k = 1; k < 3; k++) part[first(part, mesh.vertex(f, k))] = first(part, mesh.vertex(f, 0));
        double[] volumes = new double[part.length];
        double[] offsets = new double[9];
        for (int f = 0; f < mesh.faces(); f++) {
            int of = first(part, mesh.vertex(f, 0));
            volumes[of] = volume(mesh, of, f, offsets) + volumes[of];
        }
        for (int f = 0; f < mesh.faces(); f++) if (!(volumes[first(part, mesh.vertex(f, 0))] > 0)) return false;
        return true;
    }

    private static int first(int[] part, int vertex) {
        int v = vertex;
        while (part[v] != v) {
            part[v] = part[part[v]];
            v = part[v];
        }
        return v;
    }

    /** Six times the volume between a vertex and a face. @param p takes where the corners are from that vertex on */
    private static double volume(Mesh mesh, int from, int face, double[] p) {
        float[] positions = mesh.positions();
        for (int i = 0; i < 9; i++) {
            int corner = mesh.vertex(face, i / 3);
            p[i] = (double) positions[3 * corner + i % 3] - positions[3 * from + i % 3];
        }
        return p[0] * (p[4] * p[8] - p[5] * p[7])
                + p[1] * (p[5] * p[6] - p[3] * p[8])
                + p[2] * (p[3] * p[7] - p[4] * p[6]);
    }
}
