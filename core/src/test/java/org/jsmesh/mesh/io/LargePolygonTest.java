package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Large polygons are cut at the ears that looking at every corner in turn finds, with about n log n tests. */
class LargePolygonTest {
    /** Outlines, by the number of corners. */
    enum Outline {
        STAR {
            @Override
            double[] of(int n, Random random) {
                return polar(n, i -> 1 + i % 2, i -> 2 * Math.PI * i / n);
            }
        },
        COMB {
            @Override
            double[] of(int n, Random random) {
                double[] xy = new double[2 * n];
                for (int i = 0; i < n; i++) {
                    xy[2 * i] = i < 2 ? i * n : n - (i - 2) * (double) n / (n - 3);
                    xy[2 * i + 1] = i < 2 ? -1 : i % 2 == 0 ? 0 : 500;
                }
                return xy;
            }
        },
        SPIRAL {
            @Override
            double[] of(int n, Random random) {
                double turns = Math.sqrt(n) / 4;
                int half = n / 2;
                return polar(
                        n,
                        i -> i < half ? 3 + turn(i, half, turns) : 1 + turn(n - 1 - i, half, turns),
                        i -> turn(i < half ? i : n - 1 - i, half, turns));
            }
        },
        /** Most corners are a millionth of the others' distance away. */
        NEEDLES {
            @Override
            double[] of(int n, Random random) {
                return polar(n, i -> Math.pow(10, -6 * random.nextDouble() * (i % 2)), i -> 2 * Math.PI * i / n);
            }
        },
        ROUGH {
            @Override
            double[] of(int n, Random random) {
                return polar(n, i -> 1 + random.nextDouble(), i -> 2 * Math.PI * i / n);
            }
        },
        /** Crosses itself. */
        TANGLE {
            @Override
            double[] of(int n, Random random) {
                return random.doubles(2 * n).toArray();
            }
        },
        /** Crosses itself, and many corners lie at the same places and on the same lines. */
        ON_A_GRID {
            @Override
            double[] of(int n, Random random) {
                return random.ints(2 * n, 0, 9).asDoubleStream().toArray();
            }
        },
        /** The same with small steps. */
        WALK {
            @Override
            double[] of(int n, Random random) {
                double[] xy = new double[2 * n];
                for (int i = 2; i < xy.length; i++) xy[i] = xy[i - 2] + random.nextInt(3) - 1;
                return xy;
            }
        };

        abstract double[] of(int n, Random random);

        private static double turn(int i, int n, double turns) {
            return 2 * Math.PI * turns * i / n;
        }

        private static double[] polar(int n, IntToDoubleFunction radius, IntToDoubleFunction angle) {
            double[] xy = new double[2 * n];
            for (int i = 0; i < n; i++) {
                double r = radius.applyAsDouble(i);
                xy[2 * i] = r * Math.cos(angle.applyAsDouble(i));
                xy[2 * i + 1] = r * Math.sin(angle.applyAsDouble(i));
            }
            return xy;
        }
    }

    @ParameterizedTest
    @EnumSource
    void shouldClipTheEarsThatAllTestsFind(Outline outline) {
        for (int n = 49; n < 700; n += 31) {
            float[] positions = positions(outline.of(n, new Random(n)));
            IntList out = new IntList();
            PolygonTriangulator.Cut cut = new PolygonTriangulator(positions).cut(range(n), 0, n, out);
            assertThat(cut).isEqualTo(PolygonTriangulator.Cut.EARS);
            assertThat(out.toArray()).as("%d corners", n).isEqualTo(new EveryEar(positions).clip());
        }
    }

    /** Thin ears through everything cross some boxes: as many as the root of all. */
    @ParameterizedTest
    @EnumSource(names = "ON_A_GRID", mode = EnumSource.Mode.EXCLUDE)
    void shouldTakeHardlyMoreTestsForEachCornerOfLargerOutlines(Outline outline) {
        double few = testsPerCorner(outline, 5000);
        assertThat(testsPerCorner(outline, 20_000)).isLessThan(2.3 * few);
        assertThat(few).isLessThan(700);
    }

    private static double testsPerCorner(Outline outline, int n) {
        PolygonTriangulator triangulator =
                new PolygonTriangulator(positions(outline.of(n, new Random(n))), Long.MAX_VALUE / 2, 0);
        IntList out = new IntList();
        triangulator.cut(range(n), 0, n, out);
        assertThat(out.size()).isEqualTo(3 * (n - 2));
        return (double) triangulator.tests() / n;
    }

    /** Fans are cheap however large. */
    @Test
    void shouldFanALargeConvexOutline() {
        int n = 20_000;
        float[] positions = positions(Outline.polar(n, i -> 1, i -> 2 * Math.PI * i / n));
        IntList out = new IntList();
        PolygonTriangulator triangulator = new PolygonTriangulator(positions);
        triangulator.cut(range(n), 0, n, out);
        assertThat(out.size()).isEqualTo(3 * (n - 2));
        assertThat(triangulator.tests()).isLessThan(100L * n);
    }

    private static float[] positions(double[] xy) {
        float[] positions = new float[xy.length / 2 * 3];
        for (int i = 0; i < xy.length; i++) positions[i / 2 * 3 + i % 2] = (float) xy[i];
        return positions;
    }

    private static int[] range(int end) {
        return IntStream.range(0, end).toArray();
    }

    /** Goes around and looks at all other corners for each one. */
    private static final class EveryEar {
        private final double[] u;
        private final double[] v;
        private final int[] next;
        private final int[] previous;

        EveryEar(float[] positions) {
            int n = positions.length / 3;
            double area = 0;
            for (int i = 0, j = n - 1; i < n; j = i++) {
                double across = (double) positions[3 * j] - positions[3 * i];
                area += across * ((double) positions[3 * j + 1] + positions[3 * i + 1]);
            }
            u = new double[n];
            v = new double[n];
            next = new int[n];
            previous = new int[n];
            for (int i = 0; i < n; i++) {
                u[i] = positions[3 * i + (area < 0 ? 1 : 0)];
                v[i] = positions[3 * i + (area < 0 ? 0 : 1)];
                next[i] = (i + 1) % n;
                previous[i] = (i + n - 1) % n;
            }
        }

        int[] clip() {
            int[] out = new int[3 * (u.length - 2)];
            int at = 0;
            int waiting = 0;
            for (int left = u.length, n = 0; left > 2; ) {
                if (left == 3 || isEar(at) || waiting >= left) {
                    out[n++] = previous[at];
                    out[n++] = at;
                    out[n++] = next[at];
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
            return out;
        }

        private boolean isEar(int b) {
            int a = previous[b];
            int c = next[b];
            if (turn(a, b, c) <= 0) return false;
            for (int p = next[c]; p != a; p = next[p]) {
                boolean isCorner = same(a, p) || same(b, p) || same(c, p);
                if (isCorner || turn(previous[p], p, next[p]) >= 0) continue;
                if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
            }
            return true;
        }

        private boolean same(int a, int b) {
            return u[a] == u[b] && v[a] == v[b];
        }

        private double turn(int a, int b, int c) {
            return (u[b] - u[a]) * (v[c] - v[a]) - (v[b] - v[a]) * (u[c] - u[a]);
        }
    }
}
