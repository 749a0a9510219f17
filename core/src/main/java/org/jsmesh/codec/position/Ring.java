package org.jsmesh.codec.position;

import org.jsmesh.codec.connectivity.ConnectivityCoder;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.CornerTable;

/**
 * What the neighbours of a vertex say about its position: their mean, the area normal of their polygon and how far they
 * are spread. In cells of the lattice's grid.
 */
final class Ring {
    private static final double[] INVERSE = new double[ConnectivityCoder.MAX_VALENCE + 3];

    static {
        for (int n = 1; n < INVERSE.length; n++) INVERSE[n] = 1.0 / n;
    }

    private final LodMesh mesh;
    private final double[] coordinates = new double[3 * ConnectivityCoder.MAX_VALENCE + 6];
    private final double[] normal = new double[3];

    private final double[] expected = new double[3];
    private double squareTimesNormal; // fields, because locals might be joined to expressions of another order
    private double inverse;

    /** Of the neighbours; at a boundary of the two neighbours along it. */
    final double[] mean = new double[3];

    /** Mean distance of the neighbours from the mean, all axes together. */
    double width;

    /** Mean distance of the neighbours from the mean, per axis. */
    final double[] spread = new double[3];

    /** The neighbours, fan vertices. */
    final int[] neighbour = new int[ConnectivityCoder.MAX_VALENCE + 2];

    /** Sum of the neighbours' tags, see {@link LodMesh#places}. */
    int tagSum;

    /** Number of neighbours; 0 when there are more than it can hold. */
    int size;

    /** Whether there is a gap between two neighbours, at a boundary. */
    boolean isOpen;

    /** Weighted mean of the neighbours' heights, see {@link #measureHeights}. */
    double height;

    /** Weighted mean of what their tangent planes fall to there. */
    double fall;

    /** Mean distance of the neighbours from their plane, along the normal's axis. */
    double bend;

    /** Axis closest to the normal, and the other two in order. */
    int normalAxis;

    int first;
    int second;

    Ring(LodMesh mesh) {
        this.mesh = mesh;
    }

    /** Measures the ring of a fan vertex. */
    void measure(int fan) {
        int[] data = mesh.table().data();
        int start = mesh.table().cornerOf(fan);
        int c = start;
        int n = 0;
        int gap = -1;
        do {
            int v = data[CornerTable.next(c)];
            if (v < 0) {
                gap = n;
            } else {
                if (n == neighbour.length) {
                    size = 0;
                    return;
                }
                neighbour[n++] = v;
            }
            c = data[c + 4];
        } while (c != start);
        measure(n, gap);
    }

    /**
     * Measures a ring whose vertices are known: {@code list[from .. to − 1]}, at most
     * {@link ConnectivityCoder#MAX_VALENCE} + 2 of them.
     */
    void measure(int[] list, int from, int to) {
        int n = 0;
        int gap = -1;
        for (int i = from; i < to; i++) {
            int v = list[i];
            if (v < 0) gap = n;
            else neighbour[n++] = v;
        }
        measure(n, gap);
    }

    private void measure(int n, int gap) {
        size = n;
        isOpen = gap >= 0;
        int[] places = mesh.places();
        int tags = 0;
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = 0, at = 0; i < n; i++, at += 3) {
            int from = neighbour[i] << 2;
            x += coordinates[at] = places[from];
            y += coordinates[at + 1] = places[from + 1];
            z += coordinates[at + 2] = places[from + 2];
            tags += places[from + 3];
        }
        tagSum = tags;
        if (gap >= 0) {
            int after = gap == n ? 0 : 3 * gap;
            int before = gap == 0 ? 3 * n - 3 : 3 * gap - 3;
            for (int a = 0; a < 3; a++) mean[a] = (coordinates[after + a] + coordinates[before + a]) / 2;
        } else {
            double part = INVERSE[n];
            mean[0] = part * x;
            mean[1] = part * y;
            mean[2] = part * z;
        }
        spreadAndTurn(n);
    }

    private void spreadAndTurn(int n) {
        int end = 3 * n;
        double mx = mean[0];
        double my = mean[1];
        double mz = mean[2];
        double sx = 0;
        double sy = 0;
        double sz = 0;
        double nx = 0;
        double ny = 0;
        double nz = 0;
        double lastX = coordinates[end - 3] - mx;
        double lastY = coordinates[end - 2] - my;
        double lastZ = coordinates[end - 1] - mz;
        for (int i = 0; i < end; i += 3) {
            double x = coordinates[i] - mx;
            double y = coordinates[i + 1] - my;
            double z = coordinates[i + 2] - mz;
            sx += Math.abs(x);
            sy += Math.abs(y);
            sz += Math.abs(z);
            nx = nx + lastY * z - lastZ * y;
            ny = ny + lastZ * x - lastX * z;
            nz = nz + lastX * y - lastY * x;
            lastX = x;
            lastY = y;
            lastZ = z;
        }
        double part = INVERSE[n];
        spread[0] = part * sx;
        spread[1] = part * sy;
        spread[2] = part * sz;
        width = part * (sx + sy + sz);
        normal[0] = nx;
        normal[1] = ny;
        normal[2] = nz;
        double ax = Math.abs(nx);
        double ay = Math.abs(ny);
        double az = Math.abs(nz);
        normalAxis = ax >= ay && ax >= az ? 0 : ay >= az ? 1 : 2;
        first = normalAxis == 0 ? 1 : 0;
        second = normalAxis == 2 ? 1 : 2;
    }

    /** The expected position of the vertex: the mean, on the neighbours' plane. */
    double[] expected() {
        System.arraycopy(mean, 0, expected, 0, 3);
        expected[normalAxis] = height(PositionCoder.round(mean[first]), PositionCoder.round(mean[second]));
        return expected;
    }

    /** Cells from the mean to the last neighbour, which is the vertex that was split. */
    double last(int axis) {
        return coordinates[3 * size - 3 + axis] - mean[axis];
    }

    /** Cells from the mean to the middle of the two neighbours beside the last one. */
    double besideLast(int axis) {
        return (coordinates[axis] + coordinates[Math.max(0, 3 * size - 6) + axis]) / 2 - mean[axis];
    }

    /** Of the neighbours: how much farther the second coordinate lies from the mean where the first does by 1. */
    double slant() {
        double squares = 0;
        double products = 0;
        double p0 = mean[first];
        double q0 = mean[second];
        for (int i = 0; i < 3 * size; i += 3) {
            double p = coordinates[i + first] - p0;
            squares += p * p;
            products += p * (coordinates[i + second] - q0);
        }
        return squares == 0 ? 0 : products / squares;
    }

    /**
     * Measures what the neighbours say of the coordinate along the normal's axis, given the other two: their own
     * heights, and how far their tangent planes fall to there, both weighted by the inverse of the squared distance;
     * and how far they lie from their plane.
     */
    void measureHeights(double[] normals, int p, int q) {
        int axis = normalAxis;
        double tiltP = normal[axis] == 0 ? 0 : normal[first] / normal[axis];
        double tiltQ = normal[axis] == 0 ? 0 : normal[second] / normal[axis];
        double middle = mean[axis] + tiltP * mean[first] + tiltQ * mean[second];
        double weights = 0;
        double heights = 0;
        double falls = 0;
        double bends = 0;
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
            if (na == 0) na = 1; // no normal: it falls by nothing
            // One division for both the weight and the slope.
            squareTimesNormal = (dp * dp + dq * dq + 1) * na;
            inverse = 1 / squareTimesNormal;
            double weight = inverse * na;
            double z = coordinates[at + axis];
            weights += weight;
            heights += weight * z;
            falls += (np * dp + nq * dq) * inverse;
            bends += Math.abs(z + tiltP * coordinates[at + first] + tiltQ * coordinates[at + second] - middle);
        }
        height = heights / weights;
        fall = falls / weights;
        bend = INVERSE[size] * bends;
    }

    /**
     * Height of the polygon's plane along the normal's axis, given the other two coordinates; the mean where that would
     * be far off.
     */
    double height(int p, int q) {
        double middle = mean[normalAxis];
        if (normal[normalAxis] == 0) return middle;
        double tilt = (normal[first] * (p - mean[first]) + normal[second] * (q - mean[second])) / normal[normalAxis];
        return Math.abs(tilt) <= width ? middle - tilt : middle;
    }
}
