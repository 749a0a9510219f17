package org.jsmesh.encode.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.assertj.core.data.Offset;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ClosestPointTest {
    private static final Offset<Double> ROUNDING = within(1e-12);
    private static final float[] TRIANGLE = {0, 0, 0, 4, 0, 0, 0, 4, 0};

    @Property(tries = 40, seed = "1")
    void shouldBeAsFarAsTheNearestTriangle(@ForAll RandomMeshes kind, @ForAll long seed) {
        Mesh mesh = kind.mesh(seed);
        int[] triangles = new int[3 * mesh.faces()];
        for (int i = 0; i < triangles.length; i++) triangles[i] = mesh.vertex(i / 3, i % 3);
        TriangleTree tree = new TriangleTree(mesh.positions(), triangles, mesh.faces());
        TriangleTree.Cursor cursor = new TriangleTree.Cursor(tree);
        ClosestPoint closest = new ClosestPoint();
        Random random = new Random(seed);
        for (int i = 0; i < 40; i++) {
            double[] p = {8 * random.nextDouble() - 4, 8 * random.nextDouble() - 4, 4 * random.nextDouble() - 2};
            double expected = Math.sqrt(cursor.squaredDistance(p[0], p[1], p[2]));
            closest.find(mesh.positions(), triangles, 3 * tree.face(cursor.nearest()), p[0], p[1], p[2]);
            for (double share : closest.shares) assertThat(share).isBetween(0.0, 1 + 1e-9);
            double squares = 0;
            for (int a = 0; a < 3; a++) {
                double at = -p[a];
                for (int j = 0; j < 3; j++) {
                    int vertex = triangles[3 * tree.face(cursor.nearest()) + j];
                    at += closest.shares[j] * mesh.positions()[3 * vertex + a];
                }
                squares += at * at;
            }
            assertThat(Math.sqrt(squares)).isCloseTo(expected, within(1e-5));
        }
    }

    /** Of coarse levels, corners may coincide or lie in a row. */
    @ParameterizedTest
    @CsvSource({"0, 0, 0", "0, 0, 4", "0, 4, 0", "0, 4, 2"})
    void shouldFindAPointOfADegenerateTriangle(float a, float b, float c) {
        ClosestPoint closest = new ClosestPoint();
        closest.find(new float[] {a, 0, 0, b, 0, 0, c, 0, 0}, new int[] {0, 1, 2}, 0, 1, 5, 0);
        double[] s = closest.shares;
        assertThat(s[0] + s[1] + s[2]).isCloseTo(1, within(1e-12));
        assertThat(s[0] * a + s[1] * b + s[2] * c).isCloseTo(Math.min(1, Math.max(b, c)), within(1e-12));
    }

    @Test
    void shouldGiveTheNormalEvenForAPointOfTheTriangle() {
        ClosestPoint closest = new ClosestPoint();
        for (double height : new double[] {3, 0}) {
            closest.find(TRIANGLE, 0, 1, 1, height);
            assertThat(closest.shares).containsExactly(new double[] {0.5, 0.25, 0.25}, ROUNDING);
            assertThat(closest.direction).containsExactly(new double[] {0, 0, 1}, ROUNDING);
        }
    }

    @Test
    void shouldGiveTheDirectionToAPointBesideTheTriangle() {
        ClosestPoint closest = new ClosestPoint();
        closest.find(TRIANGLE, 0, 1, -3, 4);
        assertThat(closest.shares).containsExactly(new double[] {0.75, 0.25, 0}, ROUNDING);
        assertThat(closest.direction).containsExactly(new double[] {0, -0.6, 0.8}, ROUNDING);
    }

    @Test
    void shouldGiveNoDirectionToAPointOfADegenerateTriangle() {
        ClosestPoint closest = new ClosestPoint();
        closest.find(new float[] {0, 0, 0, 4, 0, 0, 2, 0, 0}, 0, 1, 0, 0);
        assertThat(closest.direction).containsOnly(0);
    }
}
