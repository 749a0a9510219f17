package org.jsmesh.encode.measure;

import java.util.Arrays;
import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.TriangleDistance;

/**
 * A bounding-volume hierarchy over triangles for nearest-point queries: median splits along the longest side of the
 * centroids' box. Node i has its left child at i + 1.
 *
 * <p>It answers any points about one surface. {@link PointField} is for the opposite, the same points and one surface
 * after the other, which is not worth ordering for so few points.
 *
 * <p>Triangles are kept in the order of the leaves, so neighbours in the order are neighbours in space. Thread-safe
 * once built; queries go through a {@link Cursor}.
 */
final class TriangleTree {
    private static final int LEAF = 4;

    private final float[] corners; // nine coordinates per triangle
    private final int[] triangles; // where those of a triangle are in place of that, three vertices each; or null
    private final float[] vertices; // null where nobody asks
    private final int size;
    private final float[] boxes; // low x, y, z, high x, y, z per node
    private final int[] right; // right child of an inner node, −1 for leaves
    private final int[] first; // first triangle of a leaf
    private final int[] count;
    private int nodes;
    private final int[] faces; // number of each triangle before it was sorted

    /** @param triangles three vertices each, {@code size} of them, at least one */
    TriangleTree(float[] positions, int[] triangles, int size) {
        this(positions, triangles, size, true);
    }

    /** A tree of all triangles that shares the arrays. It takes half the memory, and queries a little more time. */
    static TriangleTree of(float[] positions, int[] triangles) {
        return new TriangleTree(positions, triangles, triangles.length / 3, false);
    }

    private TriangleTree(float[] positions, int[] triangles, int size, boolean copies) {
        if (size < 1) throw new IllegalArgumentException("no triangles");
        this.size = size;
        // Before anything is allocated.
        int coordinates = copies ? Sizes.of(9, size, "triangles to measure") : 0;
        int[] order = new int[size];
        for (int i = 0; i < size; i++) order[i] = i;
        int most = Math.max(1, size); // a leaf holds at least two triangles when there is another
        right = new int[most];
        first = new int[most];
        count = new int[most];
        split(order, Centroids.of(positions, triangles, size), 0, size);
        faces = order;
        boxes = new float[Sizes.of(6, nodes, "boxes of triangles to measure")];
        this.triangles = copies ? null : triangles;
        corners = copies ? new float[coordinates] : positions;
        vertices = copies ? copy(positions, triangles) : null;
        fit(0);
    }

    /** Copies the corners in the order of the leaves, and returns each vertex once in this order. */
    private float[] copy(float[] positions, int[] triangles) {
        boolean[] seen = new boolean[positions.length / 3];
        float[] found = new float[positions.length];
        int n = 0;
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < 3; j++) {
                int v = triangles[3 * faces[i] + j];
                System.arraycopy(positions, 3 * v, corners, 9 * i + 3 * j, 3);
                if (seen[v]) continue;
                seen[v] = true;
                System.arraycopy(positions, 3 * v, found, n, 3);
                n += 3;
            }
        }
        return Arrays.copyOf(found, n);
    }

    int size() {
        return size;
    }

    /** Nine coordinates per triangle, in the order of the leaves. */
    float[] corners() {
        return corners;
    }

    /** The area of the triangles, in the order of the leaves: points that are strewn there are near one another. */
    SurfacePoints surface() {
        int[] triangles = new int[3 * size];
        for (int i = 0; i < triangles.length; i++) triangles[i] = i;
        return new SurfacePoints(corners, triangles);
    }

    /** x, y, z of the vertices of all triangles, each once, in the order of the leaves. */
    float[] vertices() {
        return vertices;
    }

    /** The number that a triangle had when the tree was built. */
    int face(int triangle) {
        return faces[triangle];
    }

    private int split(int[] order, float[] centroids, int from, int n) {
        int node = nodes++;
        first[node] = from;
        count[node] = n;
        right[node] = -1;
        if (n > LEAF) {
            int axis = Centroids.longestAxis(order, centroids, from, n);
            int half = n / 2;
            Centroids.select(order, centroids, axis, from, from + n - 1, from + half);
            split(order, centroids, from, half);
            right[node] = split(order, centroids, from + half, n - half);
        }
        return node;
    }

    private void fit(int node) {
        int at = 6 * node;
        for (int axis = 0; axis < 3; axis++) {
            boxes[at + axis] = Float.POSITIVE_INFINITY;
            boxes[at + 3 + axis] = Float.NEGATIVE_INFINITY;
        }
        if (right[node] < 0) {
            for (int i = 3 * first[node]; i < 3 * (first[node] + count[node]); i++) {
                int corner = triangles == null ? 3 * i : 3 * triangles[3 * faces[i / 3] + i % 3];
                for (int axis = 0; axis < 3; axis++) grow(at + axis, corners[corner + axis], corners[corner + axis]);
            }
            return;
        }
        for (int child : new int[] {node + 1, right[node]}) {
            fit(child);
            for (int axis = 0; axis < 3; axis++) grow(at + axis, boxes[6 * child + axis], boxes[6 * child + 3 + axis]);
        }
    }

    private void grow(int at, float low, float high) {
        boxes[at] = Math.min(boxes[at], low);
        boxes[at + 3] = Math.max(boxes[at + 3], high);
    }

    private double boxDistance(int node, double x, double y, double z) {
        int b = 6 * node;
        double dx = Math.max(Math.max(boxes[b] - x, x - boxes[b + 3]), 0);
        double dy = Math.max(Math.max(boxes[b + 1] - y, y - boxes[b + 4]), 0);
        double dz = Math.max(Math.max(boxes[b + 2] - z, z - boxes[b + 5]), 0);
        return dx * dx + dy * dy + dz * dz;
    }

    private double distance(int triangle, double x, double y, double z) {
        if (triangles != null) {
            int t = 3 * faces[triangle];
            return TriangleDistance.squared(
                    corners, 3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2], x, y, z);
        }
        int t = 9 * triangle;
        return TriangleDistance.squared(corners, t, t + 3, t + 6, x, y, z);
    }

    /** Asks a tree for one point after the other. Queries are fastest when a point is near the one before. */
    static final class Cursor {
        private static final int DEPTH = 64;

        private final TriangleTree tree;
        private final int[] stack = new int[DEPTH];
        private final double[] distances = new double[DEPTH];
        private final int most;
        private int nearest;

        Cursor(TriangleTree tree) {
            this(tree, Integer.MAX_VALUE);
        }

        /** @param most nodes and triangles to look at for a point; the triangle found then is close, if not nearest */
        Cursor(TriangleTree tree, int most) {
            this.tree = tree;
            this.most = most;
        }

        /** The triangle that was nearest to the point asked last. */
        int nearest() {
            return nearest;
        }

        /** Makes the next query begin with a triangle that is near, out of so many all over and of those around it. */
        void beginNear(double x, double y, double z, int spread) {
            int step = 1 + (tree.size - 1) / spread;
            double best = tree.distance(nearest, x, y, z);
            for (int i = step / 2; i < tree.size; i += step) best = nearer(i, best, x, y, z);
            while (step > 1) {
                step = (step + 1) / 2;
                int middle = nearest;
                if (middle >= step) best = nearer(middle - step, best, x, y, z);
                if (middle + step < tree.size) best = nearer(middle + step, best, x, y, z);
            }
        }

        private double nearer(int triangle, double best, double x, double y, double z) {
            double d = tree.distance(triangle, x, y, z);
            if (d >= best) return best;
            nearest = triangle;
            return d;
        }

        /** Squared distance from a point to the nearest triangle. */
        double squaredDistance(double x, double y, double z) {
            return squaredDistance(x, y, z, -1);
        }

        /** The same, but returns any squared distance up to {@code enough} that it finds. */
        double squaredDistance(double x, double y, double z, double enough) {
            TriangleTree t = tree;
            double best = t.distance(nearest, x, y, z);
            if (best <= enough) return best;
            int depth = 1;
            int left = most;
            stack[0] = 0;
            distances[0] = 0;
            while (depth > 0 && left > 0) {
                depth--;
                if (distances[depth] >= best) continue;
                int node = stack[depth];
                while (t.right[node] >= 0) {
                    left--;
                    int near = node + 1;
                    int far = t.right[node];
                    double nearDistance = t.boxDistance(near, x, y, z);
                    double farDistance = t.boxDistance(far, x, y, z);
                    if (farDistance < nearDistance) {
                        int node2 = near;
                        near = far;
                        far = node2;
                        double d = nearDistance;
                        nearDistance = farDistance;
                        farDistance = d;
                    }
                    if (farDistance < best) {
                        stack[depth] = far;
                        distances[depth++] = farDistance;
                    }
                    node = nearDistance < best ? near : -1;
                    if (node < 0) break;
                }
                if (node < 0) continue;
                left -= t.count[node];
                for (int i = t.first[node]; i < t.first[node] + t.count[node]; i++) {
                    double d = t.distance(i, x, y, z);
                    if (d < best) {
                        best = d;
                        nearest = i;
                        if (best <= enough) return best;
                    }
                }
            }
            return best;
        }
    }
}
