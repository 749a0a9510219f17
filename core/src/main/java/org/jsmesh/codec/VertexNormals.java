package org.jsmesh.codec;

import java.util.Arrays;
import org.jsmesh.mesh.CornerTable;

/** Area normals of the vertices at the start of a pass, in cells of the lattice's grid, squared. */
final class VertexNormals {
    private final LodMesh mesh;
    private double[] normals = new double[0];

    VertexNormals(LodMesh mesh) {
        this.mesh = mesh;
    }

    /** x, y, z per fan vertex; of those at the start of the pass. */
    double[] values() {
        return normals;
    }

    /** Computes the normals of all fan vertices. */
    void compute() {
        int size = 3 * mesh.fans();
        if (size > normals.length) normals = new double[2 * size];
        else Arrays.fill(normals, 0, size, 0);
        double[] n = normals;
        int[] cells = mesh.cells();
        int[] data = mesh.table().data();
        int end = CornerTable.STRIDE * mesh.table().faces();
        for (int f = 0; f < end; f += CornerTable.STRIDE) {
            int a = 3 * data[f];
            int b = 3 * data[f + 1];
            int c = 3 * data[f + 2];
            if ((a | b | c) < 0) continue; // a dummy face
            double ux = cells[b] - cells[a];
            double uy = cells[b + 1] - cells[a + 1];
            double uz = cells[b + 2] - cells[a + 2];
            double vx = cells[c] - cells[a];
            double vy = cells[c + 1] - cells[a + 1];
            double vz = cells[c + 2] - cells[a + 2];
            double x = uy * vz - uz * vy;
            double y = uz * vx - ux * vz;
            double z = ux * vy - uy * vx;
            n[a] += x;
            n[a + 1] += y;
            n[a + 2] += z;
            n[b] += x;
            n[b + 1] += y;
            n[b + 2] += z;
            n[c] += x;
            n[c + 1] += y;
            n[c + 2] += z;
        }
    }
}
