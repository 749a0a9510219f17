package org.jsmesh.codec;

import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes the position of a new vertex: its cells as differences from the mean of its ring, the last of them along the axis closest to the ring's normal and corrected by the ring's plane,
 * then its points on the lattice.
 */
final class PositionCoder {
    private static final int FIRST_TANGENT = 0;
    private static final int SECOND_TANGENT = 1;
    private static final int NORMAL = 2;
    private static final int FREE = 3; // without a prediction from a ring
    private final LodMesh mesh;
    private final Lattice lattice;
    private final LatticeCoder[] points = new LatticeCoder[3];
    private final ResidualCoder residuals = new ResidualCoder(4);
    private final int[] positionBits; // encoder: of the original's vertices
    private final double[] ring = new double[3 * ConnectivityCoder.MAX_VALENCE + 6];
    private final double[] mean = new double[3];
    private final double[] normal = new double[3];
    private final double[] spread = new double[3];
    private final int[] wanted = new int[3];
    private final int[] cell = new int[3];
    private final int[] ringVertex = new int[ConnectivityCoder.MAX_VALENCE + 2];
    private int ringSize;

    /** @param positionBits raw bits of the original's positions for the encoder, else null */
    PositionCoder(LodMesh mesh, Lattice lattice, int[] positionBits) {
        this.mesh = mesh;
        this.lattice = lattice;
        this.positionBits = positionBits;
        for (int a = 0; a < 3; a++) points[a] = new LatticeCoder(lattice);
    }

    private void want(int original) {
        for (int a = 0; a < 3; a++) wanted[a] = original < 0 ? 0 : points[a].cell(positionBits[3 * original + a]);
    }

    /** Codes the position of fan vertex u, of which it is the only fan, from its ring; v is the vertex that was split. */
    void codeFromRing(BinaryCoder coder, int u, int v, int original) throws MalformedStreamException {
        want(original);
        measureRing(u);
        int n = NORMAL;
        double ax = Math.abs(normal[0]);
        double ay = Math.abs(normal[1]);
        double az = Math.abs(normal[2]);
        int axis = ax >= ay && ax >= az ? 0 : ay >= az ? 1 : 2;
        int first = axis == 0 ? 1 : 0;
        int second = axis == 2 ? 1 : 2;
        int all = (int) Math.min(1 << 28, (spread[0] + spread[1] + spread[2]) / ringSize);
        int parent = 3 * v;
        int p = codeCell(coder, FIRST_TANGENT, first, mean[first], all, parent);
        int q = codeCell(coder, SECOND_TANGENT, second, mean[second], all, parent);
        double height = mean[axis];
        if (normal[axis] != 0) {
            double tilt = (normal[first] * (p - mean[first]) + normal[second] * (q - mean[second])) / normal[axis];
            if (Math.abs(tilt) <= all) height -= tilt;
        }
        codeCell(coder, n, axis, height, all, -1);
        store(coder, u, original, ringSize);
    }

    /** Codes the position of a vertex near a prediction in cells. */
    void codeNear(BinaryCoder coder, int fan, double x, double y, double z, int expectedSize, int original)
            throws MalformedStreamException {
        want(original);
        int scale = ResidualCoder.scale(expectedSize);
        for (int a = 0; a < 3; a++) {
            int predicted = round(a == 0 ? x : a == 1 ? y : z);
            cell[a] = checked(predicted + residuals.code(coder, FREE, scale, 0, wanted[a] - predicted));
        }
        store(coder, fan, original, 0);
    }

    /** Gives a further fan of a vertex the cells of an earlier one. */
    void copy(int fan, int vertex) {
        int other = mesh.firstFan(vertex);
        System.arraycopy(mesh.cells(), 3 * other, mesh.cells(), 3 * fan, 3);
    }

    private int codeCell(BinaryCoder coder, int role, int axis, double predictedCell, int all, int parent)
            throws MalformedStreamException {
        int predicted = round(predictedCell);
        int size = (int) Math.min(1 << 28, (7 * spread[axis] / ringSize + all) / 2);
        int lean = 0;
        if (parent >= 0) {
            int d = mesh.cells()[parent + axis] - predicted;
            lean = d < 0 ? -1 : d > 0 ? 1 : 0;
        }
        cell[axis] = checked(
                predicted + residuals.code(coder, role, ResidualCoder.scale(size), lean, wanted[axis] - predicted));
        return cell[axis];
    }

    private int checked(int value) throws MalformedStreamException {
        int limit = lattice.cellLimit();
        if (value >= limit || value < -limit)
            throw new MalformedStreamException(-1, "a position is outside its lattice");
        return value;
    }

    private static int round(double x) {
        return (int) (x < 0 ? x - .5 : x + .5);
    }

    /** Codes the exact values in the cells; of the first {@code neighbours} ring vertices one in the same cell helps. */
    private void store(BinaryCoder coder, int fan, int original, int neighbours) throws MalformedStreamException {
        int vertex = mesh.vertexOf(fan);
        for (int a = 0; a < 3; a++) {
            int near = 0;
            while (near < neighbours && mesh.cells()[3 * ringVertex[near] + a] != cell[a]) near++;
            int neighbourBits = near < neighbours ? mesh.positionBits()[3 * mesh.vertexOf(ringVertex[near]) + a] : 0;
            int wantedBits = original < 0 ? 0 : positionBits[3 * original + a];
            mesh.cells()[3 * fan + a] = cell[a];
            mesh.positionBits()[3 * vertex + a] =
                    points[a].code(coder, cell[a], wantedBits, near < neighbours, neighbourBits);
        }
    }

    /** Mean, area normal and spread of the ring of u. At a boundary the mean is that of the two neighbours along it. */
    private void measureRing(int u) {
        CornerTable t = mesh.table();
        int[] cells = mesh.cells();
        int first = t.cornerOf(u);
        int c = first;
        int n = 0;
        int gap = -1;
        for (int a = 0; a < 3; a++) mean[a] = 0;
        do {
            int x = t.vertex(CornerTable.next(c));
            if (x < 0) {
                gap = n;
            } else if (3 * n + 3 <= ring.length) {
                ringVertex[n] = x;
                for (int a = 0; a < 3; a++) {
                    ring[3 * n + a] = cells[3 * x + a];
                    mean[a] += ring[3 * n + a];
                }
                n++;
            }
            c = t.swing(c);
        } while (c != first);
        ringSize = n;
        if (gap >= 0) {
            int after = gap == n ? 0 : gap;
            int before = gap == 0 ? n - 1 : gap - 1;
            for (int a = 0; a < 3; a++) mean[a] = (ring[3 * after + a] + ring[3 * before + a]) / 2;
        } else {
            for (int a = 0; a < 3; a++) mean[a] /= n;
        }
        for (int a = 0; a < 3; a++) {
            int b = (a + 1) % 3;
            int d = (a + 2) % 3;
            double sum = 0;
            double area = 0;
            for (int i = 0, j = n - 1; i < n; j = i++) {
                double difference = ring[3 * i + a] - mean[a];
                sum += difference < 0 ? -difference : difference;
                area = area
                        + (ring[3 * j + b] - mean[b]) * (ring[3 * i + d] - mean[d])
                        - (ring[3 * j + d] - mean[d]) * (ring[3 * i + b] - mean[b]);
            }
            spread[a] = sum;
            normal[a] = area;
        }
    }
}
