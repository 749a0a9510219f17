package org.jsmesh.codec;

import org.jsmesh.mesh.CornerTable;

/** What the neighbours of a vertex say about its position: their mean, the area normal of their polygon and how far they are spread. In cells of the lattice's grid. */
final class Ring {
    private final LodMesh mesh;
    private final double[] coordinates = new double[3 * ConnectivityCoder.MAX_VALENCE + 6];
    private final double[] normal = new double[3];

    private final double[] expected = new double[3];

    /** Of the neighbours; at a boundary of the two neighbours along it. */
    final double[] mean = new double[3];

    /** Sum of the distances of the neighbours from the mean, per axis. */
    final double[] spread = new double[3];

    /** The neighbours, fan vertices. */
    final int[] neighbour = new int[ConnectivityCoder.MAX_VALENCE + 2];

    /** Number of neighbours; 0 when there are more than it can hold. */
    int size;

    /** Axis closest to the normal, and the other two in order. */
    int normalAxis;

    int first;
    int second;

    Ring(LodMesh mesh) {
        this.mesh = mesh;
    }

    /** Measures the ring of a fan vertex. */
    void measure(int fan) {
        collect(fan);
        if (size == 0) return;
        for (int a = 0; a < 3; a++) {
            int b = a == 2 ? 0 : a + 1;
            int d = b == 2 ? 0 : b + 1;
            double sum = 0;
            double area = 0;
            double lastB = coordinates[3 * size - 3 + b] - mean[b];
            double lastD = coordinates[3 * size - 3 + d] - mean[d];
            for (int i = 0; i < 3 * size; i += 3) {
                double difference = coordinates[i + a] - mean[a];
                sum += difference < 0 ? -difference : difference;
                double thisB = coordinates[i + b] - mean[b];
                double thisD = coordinates[i + d] - mean[d];
                area = area + lastB * thisD - lastD * thisB;
                lastB = thisB;
                lastD = thisD;
            }
            spread[a] = sum;
            normal[a] = area;
        }
        double x = Math.abs(normal[0]);
        double y = Math.abs(normal[1]);
        double z = Math.abs(normal[2]);
        normalAxis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        first = normalAxis == 0 ? 1 : 0;
        second = normalAxis == 2 ? 1 : 2;
    }

    /** Where the vertex is to be expected: the mean, on the neighbours' plane. */
    double[] expected() {
        System.arraycopy(mean, 0, expected, 0, 3);
        expected[normalAxis] = height(PositionCoder.round(mean[first]), PositionCoder.round(mean[second]));
        return expected;
    }

    private void collect(int fan) {
        CornerTable t = mesh.table();
        int[] data = t.data();
        int[] cells = mesh.cells();
        int start = t.cornerOf(fan);
        int c = start;
        int n = 0;
        int gap = -1;
        double x = 0;
        double y = 0;
        double z = 0;
        do {
            int v = data[CornerTable.next(c)];
            if (v < 0) {
                gap = n;
            } else {
                if (n == neighbour.length) {
                    size = 0;
                    return;
                }
                neighbour[n] = v;
                x += coordinates[3 * n] = cells[3 * v];
                y += coordinates[3 * n + 1] = cells[3 * v + 1];
                z += coordinates[3 * n + 2] = cells[3 * v + 2];
                n++;
            }
            c = data[c + 4];
        } while (c != start);
        size = n;
        if (gap >= 0) {
            int after = gap == n ? 0 : 3 * gap;
            int before = gap == 0 ? 3 * n - 3 : 3 * gap - 3;
            for (int a = 0; a < 3; a++) mean[a] = (coordinates[after + a] + coordinates[before + a]) / 2;
        } else {
            mean[0] = x / n;
            mean[1] = y / n;
            mean[2] = z / n;
        }
    }

    /** Mean distance of the neighbours from the mean, all axes together. */
    int size() {
        return (int) Math.min(1 << 28, (spread[0] + spread[1] + spread[2]) / size);
    }

    /**
     * Where a smooth surface through the neighbours is at the normal's axis, given the other two coordinates: each neighbour's tangent plane and its height, half of each, as for a
     * parabola, weighted by the inverse of the squared distance.
     */
    double smoothHeight(double[] normals, int p, int q) {
        int axis = normalAxis;
        double weights = 0;
        double heights = 0;
        for (int i = 0; i < size; i++) {
            int at = 3 * i;
            int n = 3 * neighbour[i];
            double dp = p - coordinates[at + first];
            double dq = q - coordinates[at + second];
            double np = normals[n + first];
            double nq = normals[n + second];
            double na = normals[n + axis];
            double least = (Math.abs(np) + Math.abs(nq)) / 4;
            if (na >= 0) na = Math.max(na, least);
            else na = Math.min(na, -least);
            double slope = na == 0 ? 0 : (np * dp + nq * dq) / na;
            double weight = 1 / (dp * dp + dq * dq + 1);
            weights += weight;
            heights += weight * (coordinates[at + axis] - slope / 2);
        }
        return heights / weights;
    }

    /** Where the polygon's plane is at the normal's axis, given the other two coordinates; the mean where that would be far off. */
    double height(int p, int q) {
        double middle = mean[normalAxis];
        if (normal[normalAxis] == 0) return middle;
        double tilt = (normal[first] * (p - mean[first]) + normal[second] * (q - mean[second])) / normal[normalAxis];
        return Math.abs(tilt) <= size() ? middle - tilt : middle;
    }
}
