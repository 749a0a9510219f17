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

    private static final int PAIR = 2;

    /** Of a few points, the mean distance from their centre is about this part of its root mean square. */
    private static final double DEVIATION = .9;

    private final LodMesh mesh;
    private final double[] coordinates = new double[3 * ConnectivityCoder.MAX_VALENCE + 6];
    private final double[] moments = new double[PAIR + 4]; // variances, and covariances of two axes at PAIR + their sum

    private final double[] expected = new double[3];
    private double squareTimesNormal; // fields, because locals might be joined to expressions of another order
    private double inverse;
    private double firstTilt; // of the plane: how far the normal's axis falls along the two others
    private double secondTilt;

    /** Of the neighbours; at a boundary of the two neighbours along it. */
    final double[] mean = new double[3];

    /** The sum of {@link #spread} over the axes, in cells. */
    double width;

    /** About the mean distance of the neighbours from their centre along each axis, by second moments; in cells. */
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

    /** Axis closest to the normal, and the other two in order. */
    int normalAxis;

    int first;
    int second;

    Ring(LodMesh mesh) {
        this.mesh = mesh;
    }

    /** Measures the ring of a fan vertex. */
    void measure(int fan) {
        if (mesh.isSeparate()) {
            measureSeparate(fan);
            return;
        }
        int[] data = mesh.table().data();
        int start = mesh.table().cornerOf(fan);
        int c = start;
        int n = 0;
        do {
            if (n == neighbour.length) {
                size = 0;
                return;
            }
            neighbour[n++] = data[CornerTable.next(c)];
            c = data[c + 4];
        } while (c != start);
        measure(neighbour, 0, n);
    }

    /** The other two vertices of the only triangle, and the gap behind it. */
    private void measureSeparate(int fan) {
        int first = fan - fan % 3;
        neighbour[0] = first + (fan + 1) % 3;
        neighbour[1] = first + (fan + 2) % 3;
        neighbour[2] = CornerTable.OUTSIDE;
        measure(neighbour, 0, 3);
    }

    /**
     * Measures a ring whose vertices are known: {@code list[from .. to − 1]}, at most
     * {@link ConnectivityCoder#MAX_VALENCE} + 2 of them; negative: outside.
     */
    void measure(int[] list, int from, int to) {
        int[] places = mesh.places();
        int origin = list[to - 1] < 0 ? list[from] : list[to - 1];
        double ox = places[4 * origin];
        double oy = places[4 * origin + 1];
        double oz = places[4 * origin + 2];
        double lastX = 0;
        double lastY = 0;
        double lastZ = 0;
        double sx = 0;
        double sy = 0;
        double sz = 0;
        double xx = 0;
        double yy = 0;
        double zz = 0;
        double xy = 0;
        double xz = 0;
        double yz = 0;
        double nx = 0;
        double ny = 0;
        double nz = 0;
        int tags = 0;
        int gap = -1;
        int n = 0;
        for (int i = from; i < to; i++) {
            int v = list[i];
            if (v < 0) {
                gap = n;
                continue;
            }
            neighbour[n] = v;
            int at = 4 * v;
            coordinates[3 * n] = places[at];
            coordinates[3 * n + 1] = places[at + 1];
            coordinates[3 * n + 2] = places[at + 2];
            double x = places[at] - ox;
            double y = places[at + 1] - oy;
            double z = places[at + 2] - oz;
            tags += places[at + 3];
            sx += x;
            sy += y;
            sz += z;
            xx += x * x;
            yy += y * y;
            zz += z * z;
            xy += x * y;
            xz += x * z;
            yz += y * z;
            nx = nx + lastY * z - lastZ * y;
            ny = ny + lastZ * x - lastX * z;
            nz = nz + lastX * y - lastY * x;
            lastX = x;
            lastY = y;
            lastZ = z;
            n++;
        }
        size = n;
        tagSum = tags;
        isOpen = gap >= 0;
        double part = INVERSE[n];
        sx = part * sx;
        sy = part * sy;
        sz = part * sz;
        if (isOpen) {
            int after = gap == n ? 0 : 3 * gap;
            int before = gap == 0 ? 3 * n - 3 : 3 * gap - 3;
            for (int a = 0; a < 3; a++) mean[a] = (coordinates[after + a] + coordinates[before + a]) / 2;
        } else {
            mean[0] = ox + sx;
            mean[1] = oy + sy;
            mean[2] = oz + sz;
        }
        moments[0] = part * xx - sx * sx;
        moments[1] = part * yy - sy * sy;
        moments[2] = part * zz - sz * sz;
        moments[PAIR + 1] = part * xy - sx * sy;
        moments[PAIR + 2] = part * xz - sx * sz;
        moments[PAIR + 3] = part * yz - sy * sz;
        for (int a = 0; a < 3; a++) spread[a] = deviation(moments[a]);
        width = spread[0] + spread[1] + spread[2];
        turn(nx, ny, nz);
    }

    private static double deviation(double square) {
        return DEVIATION * Math.sqrt(Math.max(0, square));
    }

    private void turn(double nx, double ny, double nz) {
        double ax = Math.abs(nx);
        double ay = Math.abs(ny);
        double az = Math.abs(nz);
        normalAxis = ax >= ay && ax >= az ? 0 : ay >= az ? 1 : 2;
        first = normalAxis == 0 ? 1 : 0;
        second = normalAxis == 2 ? 1 : 2;
        double n = normalAxis == 0 ? nx : normalAxis == 1 ? ny : nz;
        firstTilt = n == 0 ? 0 : (first == 0 ? nx : ny) / n;
        secondTilt = n == 0 ? 0 : (second == 1 ? ny : nz) / n;
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
        double squares = moments[first];
        return squares > 0 ? moments[PAIR + first + second] / squares : 0;
    }

    /** About the mean distance of the neighbours from their plane along the normal's axis, in cells. */
    double bend() {
        int axis = normalAxis;
        double p = firstTilt * moments[first] + 2 * moments[PAIR + first + axis];
        double q = secondTilt * moments[second] + 2 * moments[PAIR + second + axis];
        double both = 2 * firstTilt * secondTilt * moments[PAIR + first + second];
        return deviation(moments[axis] + firstTilt * p + secondTilt * q + both);
    }

    /**
     * Measures what the neighbours say of the coordinate along the normal's axis, given the other two: their own
     * heights, and how far their tangent planes fall to there, both weighted by the inverse of the squared distance.
     */
    void measureHeights(double[] normals, int p, int q) {
        int axis = normalAxis;
        double weights = 0;
        double heights = 0;
        double falls = 0;
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
            weights += weight;
            heights += weight * coordinates[at + axis];
            falls += (np * dp + nq * dq) * inverse;
        }
        height = heights / weights;
        fall = falls / weights;
    }

    /**
     * Height of the polygon's plane along the normal's axis, given the other two coordinates; the mean where that would
     * be far off.
     */
    double height(int p, int q) {
        double tilt = firstTilt * (p - mean[first]) + secondTilt * (q - mean[second]);
        return Math.abs(tilt) <= width ? mean[normalAxis] - tilt : mean[normalAxis];
    }
}
