package org.jsmesh.codec.lod;

import java.util.Arrays;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Sizes;

/** Area normals of the vertices at the start of a pass, in cells of the lattice's grid, squared. */
public final class VertexNormals {
    private final LodMesh mesh;
    private double[] normals = new double[0];

    public VertexNormals(LodMesh mesh) {
        this.mesh = mesh;
    }

    /** x, y, z per fan vertex; of those at the start of the pass. */
    public double[] values() {
        return normals;
    }

    /** Computes the normals of all fan vertices. */
    public void compute() {
        int size = Sizes.of(3, mesh.fans(), "vertices");
        if (size > normals.length)
            normals = new double
                    [(int) Math.min(Sizes.MOST, Math.min(2L * size, 3L * Math.max(mesh.fans(), mesh.expectedFans())))];
        else Arrays.fill(normals, 0, size, 0);
        double[] n = normals;
        int[] cells = mesh.places();
        int[] data = mesh.table().data();
        int end = CornerTable.STRIDE * mesh.table().faces();
        for (int f = 0; f < end; f += CornerTable.STRIDE) {
            int a = data[f];
            int b = data[f + 1];
            int c = data[f + 2];
            if ((a | b | c) < 0) continue; // a dummy face
            double ux = cells[4 * b] - cells[4 * a];
            double uy = cells[4 * b + 1] - cells[4 * a + 1];
            double uz = cells[4 * b + 2] - cells[4 * a + 2];
            double vx = cells[4 * c] - cells[4 * a];
            double vy = cells[4 * c + 1] - cells[4 * a + 1];
            double vz = cells[4 * c + 2] - cells[4 * a + 2];
            a *= 3;
            b *= 3;
            c *= 3;
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
