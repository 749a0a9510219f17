package org.jsmesh.mesh.io;

/**
 * Cuts one polygon into triangles: a fan from the first corner, or, when the polygon is concave, ears in the plane of
 * Newell's normal (Sutherland et al., A Characterization of Ten Hidden-Surface Algorithms, 1974; ears: Meisters,
 * Polygons Have Ears, 1975). Double arithmetic.
 */
final class PolygonTriangulator {
    /**
     * Most point-in-triangle tests for one file, besides some for each corner of a large polygon. After them, concave
     * polygons are fanned, so that no file can keep a reader busy for long.
     */
    private static final long TEST_BUDGET = 100_000_000L;

    private static final int TESTS_PER_CORNER = 1024;

    /** Polygons of more corners are worth looking for ears with lists and trees. */
    private static final int SMALL = 48;

    private final float[] positions;
    private final int testsPerCorner;
    private long mostTests;
    private long tests;
    private int corners;
    private double[] u = new double[16];
    private double[] v = new double[16];
    private int[] next = new int[16];
    private int[] previous = new int[16];

    PolygonTriangulator(float[] positions) {
        this(positions, TEST_BUDGET, TESTS_PER_CORNER);
    }

    /**
     * @param tests point-in-triangle tests, beyond which concave polygons are fanned
     * @param perCorner further ones for each corner of a large polygon
     */
    PolygonTriangulator(float[] positions, long tests, int perCorner) {
        this.positions = positions;
        testsPerCorner = perCorner;
        mostTests = tests;
    }

    /** Point-in-triangle tests so far, and visits to boxes of such points. */
    long tests() {
        return tests;
    }

    /** How a polygon was cut. */
    enum Cut {
        FAN,
        EARS,
        GIVEN_UP
    }

    /**
     * @param vertices of all polygon corners
     * @param from first corner of this polygon
     * @param to behind its last corner, at least {@code from + 3}
     * @param out takes corner numbers, three per triangle
     */
    Cut cut(int[] vertices, int from, int to, IntList out) {
        corners = to - from;
        boolean concave = corners > 3 && project(vertices, from) && hasReflex();
        if (!concave || tests > mostTests) {
            for (int i = from + 1; i + 1 < to; i++) triangle(out, from, i, i + 1);
            return concave ? Cut.GIVEN_UP : Cut.FAN;
        }
        if (corners <= SMALL) clipEars(from, out);
        else clipEarsOfLarge(from, out);
        return Cut.EARS;
    }

    /** Drops the longest axis of the normal; false when the polygon has no area. */
    private boolean project(int[] vertices, int from) {
        ensureCapacity();
        double nx = 0;
        double ny = 0;
        double nz = 0;
        for (int i = 0, j = corners - 1; i < corners; j = i++) {
            int p = 3 * vertices[from + j];
            int q = 3 * vertices[from + i];
            nx += ((double) positions[p + 1] - positions[q + 1]) * ((double) positions[p + 2] + positions[q + 2]);
            ny += ((double) positions[p + 2] - positions[q + 2]) * ((double) positions[p] + positions[q]);
            nz += ((double) positions[p] - positions[q]) * ((double) positions[p + 1] + positions[q + 1]);
        }
        double ax = Math.abs(nx);
        double ay = Math.abs(ny);
        double az = Math.abs(nz);
        if (ax + ay + az == 0) return false;
        int axis = ax > ay && ax > az ? 0 : ay > az ? 1 : 2;
        boolean turned = (axis == 0 ? nx : axis == 1 ? ny : nz) < 0;
        int first = turned ? (axis + 2) % 3 : (axis + 1) % 3;
        int second = turned ? (axis + 1) % 3 : (axis + 2) % 3;
        for (int i = 0; i < corners; i++) {
            u[i] = positions[3 * vertices[from + i] + first];
            v[i] = positions[3 * vertices[from + i] + second];
        }
        return true;
    }

    private boolean hasReflex() {
        for (int i = 0; i < corners; i++) {
            if (turn(i == 0 ? corners - 1 : i - 1, i, i + 1 == corners ? 0 : i + 1) < 0) return true;
        }
        return false;
    }

    private void link() {
        for (int i = 0; i < corners; i++) {
            next[i] = i + 1 == corners ? 0 : i + 1;
            previous[i] = i == 0 ? corners - 1 : i - 1;
        }
    }

    private void clipEars(int from, IntList out) {
        link();
        int left = corners;
        int at = 0;
        int waiting = 0;
        while (left > 3) {
            // a polygon that crosses itself may have no ear; then any corner is cut off, so that the count of triangles
            // stays right
            if (isEar(at) || waiting >= left) {
                triangle(out, from + previous[at], from + at, from + next[at]);
                next[previous[at]] = next[at];
                previous[next[at]] = previous[at];
                left--;
                waiting = 0;
                at = next[at];
            } else {
                waiting++;
            }
            at = next[at];
        }
        triangle(out, from + previous[at], from + at, from + next[at]);
    }

    /** Clips the same ears in the same order, and skips corners that are known to be none. */
    private void clipEarsOfLarge(int from, IntList out) {
        link();
        EarQueue ears = new EarQueue(corners);
        ReflexCorners reflex = new ReflexCorners(u, v, corners);
        for (int i = 0; i < corners; i++) reflex.set(i, turn(previous[i], i, next[i]) < 0);
        mostTests += (long) testsPerCorner * corners;
        int at = 0;
        for (int left = corners; left > 3; left--) {
            int ear = tests > mostTests ? at : ear(at, ears, reflex);
            int a = previous[ear];
            int c = next[ear];
            triangle(out, from + a, from + ear, from + c);
            next[a] = c;
            previous[c] = a;
            if (tests <= mostTests) {
                ears.remove(ear);
                reflex.set(ear, false);
                ears.release(ear);
                turned(a, ears, reflex);
                turned(c, ears, reflex);
            }
            at = next[c];
        }
        triangle(out, from + previous[at], from + at, from + next[at]);
    }

    /** The first ear from a corner on; where there is none, that corner. */
    private int ear(int corner, EarQueue ears, ReflexCorners reflex) {
        for (int at = ears.next(corner); at >= 0; at = ears.next(at)) {
            int a = previous[at];
            int c = next[at];
            long visits = reflex.visits();
            boolean isConvex = turn(a, at, c) > 0;
            int obstacle = isConvex ? reflex.within(this, a, at, c) : -1;
            tests += 1 + reflex.visits() - visits;
            if (isConvex && obstacle < 0 || tests > mostTests) return at;
            if (isConvex) ears.remove(at, obstacle);
            else ears.remove(at);
        }
        return corner;
    }

    /** A corner has another neighbour. */
    private void turned(int corner, EarQueue ears, ReflexCorners reflex) {
        boolean isReflex = turn(previous[corner], corner, next[corner]) < 0;
        if (reflex.has(corner) && !isReflex) ears.release(corner);
        reflex.set(corner, isReflex);
        ears.add(corner);
    }

    private boolean isEar(int corner) {
        int a = previous[corner];
        int c = next[corner];
        if (tests++ > mostTests) return true;
        if (turn(a, corner, c) <= 0) return false;
        for (int p = next[c]; p != a; p = next[p]) {
            tests++;
            if (turn(previous[p], p, next[p]) < 0 && covers(a, corner, c, p)) return false;
        }
        return true;
    }

    /** Whether the triangle contains the point, border included, unless the point lies on one of its corners. */
    boolean covers(int a, int b, int c, int p) {
        if (same(a, p) || same(b, p) || same(c, p)) return false;
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    }

    private boolean same(int a, int b) {
        return u[a] == u[b] && v[a] == v[b];
    }

    private double turn(int a, int b, int c) {
        return (u[b] - u[a]) * (v[c] - v[a]) - (v[b] - v[a]) * (u[c] - u[a]);
    }

    private static void triangle(IntList out, int a, int b, int c) {
        out.add(a);
        out.add(b);
        out.add(c);
    }

    private void ensureCapacity() {
        if (u.length >= corners) return;
        int capacity = Math.max(corners, 2 * u.length);
        u = new double[capacity];
        v = new double[capacity];
        next = new int[capacity];
        previous = new int[capacity];
    }
}
