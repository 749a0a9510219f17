package org.jsmesh.samples;

import java.util.Arrays;

/**
 * Meshes the zero level of a field by surface nets (Gibson 1998): one vertex per sheet of surface in a grid cell, four
 * cells around a crossed grid edge make a quad. Sheets are told apart as in dual marching cubes (Nielson 2004), so that
 * the mesh stays a manifold where two come close. The vertices are then relaxed along the surface, which evens out the
 * triangles.
 */
final class SurfaceNets {
    /** Negative inside; its slope is about 1, so that far from zero whole blocks of the grid can be skipped. */
    interface Field {
        double at(double x, double y, double z);
    }

    private static final int BLOCK = 4;

    private final Field field;
    private final double[] low;
    private final double step;
    private final int nx;
    private final int ny;
    private final int nz;
    private final float[] values;
    private final int[] firstVertex;

    /** Two bits per edge of the cell: which of its vertices is the edge's. */
    private final int[] edgeSheets;

    private final CellSheets sheets = new CellSheets();

    double[] positions = new double[1 << 12];
    int vertices;
    int[] triangles = new int[1 << 12];
    int corners;

    /**
     * @param low smallest corner of the grid
     * @param high largest corner; the surface must not reach it
     * @param step edge of a grid cell
     */
    SurfaceNets(Field field, double[] low, double[] high, double step) {
        this.field = field;
        this.low = low;
        this.step = step;
        nx = samples(low[0], high[0]);
        ny = samples(low[1], high[1]);
        nz = samples(low[2], high[2]);
        values = new float[nx * ny * nz];
        firstVertex = new int[values.length];
        edgeSheets = new int[values.length];
    }

    private int samples(double from, double to) {
        return ((int) StrictMath.ceil((to - from) / step) / BLOCK + 1) * BLOCK + 1;
    }

    void run(int relaxations) {
        sample();
        dropSpecks();
        placeVertices();
        connect();
        for (int i = 0; i < relaxations; i++) relax();
        positions = Arrays.copyOf(positions, 3 * vertices);
        triangles = Arrays.copyOf(triangles, corners);
    }

    /**
     * Blocks whose centre is further from the surface than their corners get the centre's value: only its sign is used.
     */
    private void sample() {
        double reach = 1.1 * step * BLOCK;
        for (int bz = 0; bz < nz; bz += BLOCK) {
            for (int by = 0; by < ny; by += BLOCK) {
                for (int bx = 0; bx < nx; bx += BLOCK) {
                    double half = BLOCK * 0.5;
                    double centre = field.at(x(bx + half), y(by + half), z(bz + half));
                    boolean near = StrictMath.abs(centre) < reach;
                    for (int k = bz; k < StrictMath.min(bz + BLOCK, nz); k++) {
                        for (int j = by; j < StrictMath.min(by + BLOCK, ny); j++) {
                            for (int i = bx; i < StrictMath.min(bx + BLOCK, nx); i++) {
                                values[index(i, j, k)] = (float) (near ? field.at(x(i), y(j), z(k)) : centre);
                            }
                        }
                    }
                }
            }
        }
    }

    /** A sample that differs from all its neighbours is finer than the grid can show: it becomes like them. */
    private void dropSpecks() {
        int[] strides = {index(1, 0, 0), index(0, 1, 0), index(0, 0, 1)};
        for (int at = strides[2]; at < values.length - strides[2]; at++) {
            boolean alone = true;
            for (int stride : strides) {
                alone &= values[at - stride] < 0 != values[at] < 0 && values[at + stride] < 0 != values[at] < 0;
            }
            if (alone) values[at] = -values[at];
        }
    }

    private void placeVertices() {
        for (int k = 0; k + 1 < nz; k++) {
            for (int j = 0; j + 1 < ny; j++) {
                for (int i = 0; i + 1 < nx; i++) placeCell(i, j, k);
            }
        }
    }

    private void placeCell(int i, int j, int k) {
        int inside = 0;
        for (int corner = 0; corner < 8; corner++) {
            if (value(i, j, k, corner) < 0) inside |= 1 << corner;
        }
        if (inside == 0 || inside == 255) return;
        sheets.separate(inside);
        int cell = index(i, j, k);
        firstVertex[cell] = vertices;
        for (int edge = 0; edge < 12; edge++) {
            if (!sheets.holds(edge, edge)) continue;
            int number = vertices - firstVertex[cell];
            for (int e = 0; e < 12; e++) {
                if (sheets.holds(edge, e)) edgeSheets[cell] |= number << 2 * e;
            }
            placeVertex(i, j, k, edge);
        }
    }

    private void placeVertex(int i, int j, int k, int sheet) {
        double[] sum = new double[3];
        int crossings = 0;
        for (int edge = 0; edge < 12; edge++) {
            if (!sheets.holds(sheet, edge)) continue;
            int corner = CellSheets.low(edge);
            double a = value(i, j, k, corner);
            double b = value(i, j, k, corner | 1 << edge / 4);
            for (int axis = 0; axis < 3; axis++) sum[axis] += corner >> axis & 1;
            sum[edge / 4] += a / (a - b);
            crossings++;
        }
        if (3 * vertices + 3 > positions.length) positions = Arrays.copyOf(positions, 2 * positions.length);
        double[] p = {x(i + sum[0] / crossings), y(j + sum[1] / crossings), z(k + sum[2] / crossings)};
        project(p);
        System.arraycopy(p, 0, positions, 3 * vertices++, 3);
    }

    private void connect() {
        int[] strides = {index(1, 0, 0), index(0, 1, 0), index(0, 0, 1)};
        for (int k = 1; k + 1 < nz; k++) {
            for (int j = 1; j + 1 < ny; j++) {
                for (int i = 1; i + 1 < nx; i++) {
                    int at = index(i, j, k);
                    for (int axis = 0; axis < 3; axis++) {
                        boolean inside = values[at] < 0;
                        if (inside == values[at + strides[axis]] < 0) continue;
                        int u = strides[(axis + 1) % 3];
                        int v = strides[(axis + 2) % 3];
                        int a = vertex(at - u - v, 4 * axis + 3);
                        int b = vertex(at - v, 4 * axis + 2);
                        int c = vertex(at, 4 * axis);
                        int d = vertex(at - u, 4 * axis + 1);
                        if (inside) quad(a, b, c, d);
                        else quad(a, d, c, b);
                    }
                }
            }
        }
    }

    private int vertex(int cell, int edge) {
        return firstVertex[cell] + (edgeSheets[cell] >> 2 * edge & 3);
    }

    private void quad(int a, int b, int c, int d) {
        if (distance2(a, c) <= distance2(b, d)) {
            triangle(a, b, c);
            triangle(a, c, d);
        } else {
            triangle(b, c, d);
            triangle(b, d, a);
        }
    }

    private void triangle(int a, int b, int c) {
        if (corners + 3 > triangles.length) triangles = Arrays.copyOf(triangles, 2 * triangles.length);
        triangles[corners++] = a;
        triangles[corners++] = b;
        triangles[corners++] = c;
    }

    /** Moves each vertex halfway to the mean of its neighbours, and back to the surface. */
    private void relax() {
        double[] sum = new double[3 * vertices];
        int[] count = new int[vertices];
        for (int t = 0; t < corners; t += 3) {
            for (int e = 0; e < 3; e++) {
                int from = triangles[t + e];
                int to = triangles[t + (e + 1) % 3];
                count[from]++;
                for (int axis = 0; axis < 3; axis++) sum[3 * from + axis] += positions[3 * to + axis];
            }
        }
        double[] p = new double[3];
        for (int v = 0; v < vertices; v++) {
            for (int axis = 0; axis < 3; axis++) {
                p[axis] = 0.5 * (positions[3 * v + axis] + sum[3 * v + axis] / count[v]);
            }
            project(p);
            System.arraycopy(p, 0, positions, 3 * v, 3);
        }
    }

    /** A Newton step along the gradient, not longer than half a cell. */
    private void project(double[] p) {
        double d = 0.02 * step;
        double f = field.at(p[0], p[1], p[2]);
        double gx = (field.at(p[0] + d, p[1], p[2]) - f) / d;
        double gy = (field.at(p[0], p[1] + d, p[2]) - f) / d;
        double gz = (field.at(p[0], p[1], p[2] + d) - f) / d;
        double slope2 = StrictMath.max(gx * gx + gy * gy + gz * gz, 1e-6);
        double move = f / slope2;
        double length = StrictMath.abs(move) * StrictMath.sqrt(slope2);
        if (length > 0.5 * step) move *= 0.5 * step / length;
        p[0] -= move * gx;
        p[1] -= move * gy;
        p[2] -= move * gz;
    }

    private double distance2(int a, int b) {
        double dx = positions[3 * a] - positions[3 * b];
        double dy = positions[3 * a + 1] - positions[3 * b + 1];
        double dz = positions[3 * a + 2] - positions[3 * b + 2];
        return dx * dx + dy * dy + dz * dz;
    }

    private double value(int i, int j, int k, int corner) {
        return values[index(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2))];
    }

    private int index(int i, int j, int k) {
        return (k * ny + j) * nx + i;
    }

    private double x(double i) {
        return low[0] + i * step;
    }

    private double y(double j) {
        return low[1] + j * step;
    }

    private double z(double k) {
        return low[2] + k * step;
    }
}
