package org.jsmesh.encode.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.TooLargeException;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TriangleTreeTest {
    @Property(tries = 60, seed = "1")
    void shouldFindTheNearestTriangle(@ForAll RandomMeshes kind, @ForAll long seed) {
        Mesh mesh = kind.mesh(seed);
        TriangleTree tree = tree(mesh);
        TriangleTree.Cursor cursor = new TriangleTree.Cursor(tree);
        Random random = new Random(seed);
        for (int i = 0; i < 40; i++) {
            double x = 8 * random.nextDouble() - 4;
            double y = 8 * random.nextDouble() - 4;
            double z = 4 * random.nextDouble() - 2;
            double expected = Double.POSITIVE_INFINITY;
            for (int f = 0; f < mesh.faces(); f++) expected = Math.min(expected, distance(mesh, f, x, y, z));
            assertThat(Math.sqrt(cursor.squaredDistance(x, y, z))).isCloseTo(expected, within(1e-5));
        }
    }

    @Test
    void shouldStopEarlyWhenAnythingNearIsEnough() {
        TriangleTree tree = tree(RandomMeshes.TORUS.mesh(5));
        double exact = new TriangleTree.Cursor(tree).squaredDistance(3, 1, 2);
        double enough = new TriangleTree.Cursor(tree).squaredDistance(3, 1, 2, 4 * exact);
        assertThat(enough).isBetween(exact, 4 * exact);
        assertThat(new TriangleTree.Cursor(tree).squaredDistance(3, 1, 2, exact / 2))
                .isEqualTo(exact);
    }

    @Test
    void shouldRefuseMoreThanAnArrayHolds() {
        assertThatThrownBy(() -> new TriangleTree(new float[9], new int[9], 500_000_000))
                .isInstanceOf(TooLargeException.class);
    }

    @Test
    void shouldKeepEveryReferencedVertexOnce() {
        float[] positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 9, 1, 1, 0};
        TriangleTree tree = new TriangleTree(positions, new int[] {0, 1, 2, 1, 4, 2}, 2);
        assertThat(tree.vertices()).hasSize(12).doesNotContain(9);
        assertThat(tree.corners()).hasSize(18);
    }

    /** Bases are coarse enough for corners to coincide. */
    @ParameterizedTest
    @CsvSource({"0, 0, 1", "0, 1, 0", "1, 0, 0", "0, 0, 0"})
    void shouldMeasureToDegenerateTriangles(int a, int b, int c) {
        float[] positions = {0, 0, 0, 2, 0, 0};
        TriangleTree.Cursor cursor = new TriangleTree.Cursor(new TriangleTree(positions, new int[] {a, b, c}, 1));
        double expected = a + b + c == 0 ? 2 : 1;
        assertThat(cursor.squaredDistance(1, 1, 0)).isEqualTo(expected);
    }

    @Test
    void shouldRefuseNoTriangles() {
        assertThatThrownBy(() -> new TriangleTree(new float[0], new int[0], 0))
                .isInstanceOf(IllegalArgumentException.class);
    }

    private static TriangleTree tree(Mesh mesh) {
        int[] triangles = new int[3 * mesh.faces()];
        for (int i = 0; i < triangles.length; i++) triangles[i] = mesh.vertex(i / 3, i % 3);
        return new TriangleTree(mesh.positions(), triangles, mesh.faces());
    }

    /** By other means: the smallest of the distances to the three sides, and to the plane when the foot lies inside. */
    private static double distance(Mesh mesh, int face, double... p) {
        double[][] t = new double[3][3];
        for (int i = 0; i < 9; i++) t[i / 3][i % 3] = mesh.positions()[3 * mesh.vertex(face, i / 3) + i % 3];
        double best = Math.min(toSegment(p, t[0], t[1]), Math.min(toSegment(p, t[1], t[2]), toSegment(p, t[2], t[0])));
        double[] n = cross(minus(t[1], t[0]), minus(t[2], t[0]));
        double length = Math.sqrt(dot(n, n));
        if (length < 1e-9) return best;
        for (int i = 0; i < 3; i++) {
            if (dot(cross(minus(t[(i + 1) % 3], t[i]), minus(p, t[i])), n) < 0) return best;
        }
        return Math.min(best, Math.abs(dot(minus(p, t[0]), n)) / length);
    }

    private static double toSegment(double[] p, double[] a, double[] b) {
        double[] ab = minus(b, a);
        double s = dot(ab, ab) == 0 ? 0 : Math.max(0, Math.min(1, dot(minus(p, a), ab) / dot(ab, ab)));
        double[] d = minus(p, new double[] {a[0] + s * ab[0], a[1] + s * ab[1], a[2] + s * ab[2]});
        return Math.sqrt(dot(d, d));
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
