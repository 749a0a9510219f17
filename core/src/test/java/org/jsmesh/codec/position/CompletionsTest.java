package org.jsmesh.codec.position;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.jsmesh.codec.connectivity.ConnectivityCoder;
import org.jsmesh.codec.connectivity.SplitLane;
import org.jsmesh.codec.lod.LodMesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CompletionsTest {
    private static final int LARGEST = ConnectivityCoder.MAX_VALENCE + 2;

    /** Numbers of vertices; a gap in a ring, and nothing beyond an edge. */
    private static final int NONE = -1;

    /** Corners of a triangular grid with 10 cells between neighbours, about (100, 200, 7). */
    private static int[] corner(int i, int j) {
        return new int[] {100 + 10 * i, 200 + 10 * j, 7};
    }

    @Test
    void shouldTakeTheMiddleOfAnEvenCount() {
        Rings square = new Rings(new int[][] {{0, 0, 0}, {10, 0, 0}, {10, 20, 0}, {0, 20, 0}});
        // doubled: 0, 0, 10, 10, 20, 20 and 0, 0, 20, 20, 40, 40
        square.expect(5, 10, 10, 20);
    }

    @Test
    void shouldTakeTheOneInTheMiddleOfAnOddCount() {
        Rings triangle = new Rings(new int[][] {{0, 0, 0}, {6, 0, 0}, {0, 12, 0}, {5, -3, 0}, {8, 8, 0}, {-9, 7, 0}});
        triangle.beyond = new int[] {3, 4, 5};
        triangle.size = 3;
        // doubled: −12, −4, 0, 2, 6, 6, 12, 12, 18 and −24, 0, 6, 8, 10, 12, 12, 24, 24
        triangle.expect(3, 6, 5, 3);
    }

    @Test
    void shouldDoWithTheSmallestRing() {
        Rings triangle = new Rings(new int[][] {{0, 0, 0}, {6, 0, 0}, {0, 12, 0}});
        // doubled: −12, 0, 6, 6, 12, 12 and −24, 0, 12, 12, 24, 24
        triangle.expect(3, 6, 6, 12);
    }

    @Test
    void shouldDoWithTheSmallestRingAtABoundary() {
        Rings edge = new Rings(new int[][] {{0, 0, 0}, {8, 4, 6}});
        edge.gap = 0;
        // two vertices have no normal, so the axes are y and z; doubled: −8, 4, 16 and −12, 6, 24
        edge.expect(2, 12, 3, 18);
    }

    @Test
    void shouldCompleteAGridInWhichANeighbourIsMissing() {
        Rings grid = new Rings(new int[][] {
            corner(1, 0), corner(0, 1), corner(-1, 1), corner(-1, 0), corner(0, -1),
            corner(1, 1), corner(-1, 2), corner(-2, 1), corner(-1, -1), corner(1, -1)
        });
        grid.size = 5;
        grid.expect(100, 5, 200, 5);
        grid.beyond = new int[] {5, 6, 7, 8, 9};
        grid.expect(100, 0, 200, 0);
        assertThat(grid.ring.mean[0]).as("the mean of the ring").isEqualTo(98);
    }

    @Test
    void shouldDoWithoutWhatIsNotBeyondAnEdge() {
        Rings square = new Rings(new int[][] {{0, 0, 0}, {10, 0, 0}, {10, 20, 0}, {0, 20, 0}, {9000, -9000, 0}});
        square.size = 4;
        square.beyond = new int[] {NONE, 4, 4, NONE};
        // doubled: −17980, −17960, 0, 0, 10, 10, 20, 20 and 0, 0, 20, 20, 40, 40, 18040, 18080
        square.expect(2.5, 10, 15, 9010);
    }

    @Test
    void shouldNotLookBeyondAnEdgeAtABoundary() {
        Rings grid =
                new Rings(new int[][] {corner(1, 0), corner(0, 1), corner(-1, 1), corner(-1, 0), {9000, -9000, 0}});
        grid.size = 4;
        grid.gap = 4;
        double[] without = grid.find();
        grid.beyond = new int[] {4, 4, 4, 4, 4};
        assertThat(grid.find()).isEqualTo(without);
    }

    @Test
    void shouldNotLookBeyondTheEdgesOfALargeRing() {
        Random random = new Random(1);
        Rings large = Rings.random(random, SplitLane.FEW + 1, false);
        double[] with = large.find();
        large.beyond = new int[0];
        assertThat(large.find()).isEqualTo(with);
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 4, 5, 6, 7, 8, 15, 40, LARGEST})
    void shouldFindTheSameBitsWhereverTheRingBegins(int size) {
        Random random = new Random(size);
        for (int trial = 0; trial < 50; trial++) {
            Rings rings = Rings.random(random, size, true);
            double[] found = rings.find();
            rings.turn(1 + random.nextInt(size - 1));
            assertThat(rings.find()).isEqualTo(found);
            rings.reverse();
            assertThat(rings.find()).isEqualTo(found);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 4, 5, 6, 7, 8, 15, 40, LARGEST})
    void shouldFindTheMirrorImageOfTheMedians(int size) {
        Random random = new Random(size);
        for (int trial = 0; trial < 50; trial++) {
            Rings rings = Rings.random(random, size, true);
            double[] found = rings.find();
            rings.mirror();
            double[] mirrored = rings.find();
            assertThat(mirrored[0]).isEqualTo(-found[0]);
            assertThat(mirrored[2]).isEqualTo(found[2]);
            assertThat(mirrored[3]).isEqualTo(found[3]);
            // where four divide the count, the quartiles are not as far from either end
            if (rings.count() % 4 != 0) assertThat(mirrored[1]).isEqualTo(found[1]);
        }
    }

    @Test
    void shouldFindWhatSortingAllCompletionsFinds() {
        Random random = new Random(5);
        for (int trial = 0; trial < 3000; trial++) {
            boolean few = random.nextInt(4) > 0;
            Rings rings = Rings.random(random, few ? 3 + random.nextInt(6) : 3 + random.nextInt(LARGEST - 2), false);
            if (random.nextInt(4) == 0) rings.gap = random.nextInt(rings.size + 1);
            assertThat(rings.find())
                    .as("ring of %d, gap %d", rings.size, rings.gap)
                    .isEqualTo(rings.slowly());
        }
    }

    @Test
    void shouldNotOverflowAtTheLargestCells() {
        int far = (1 << 28) - 1;
        Rings rings = new Rings(new int[][] {{-far, -far, 0}, {far, -far, 0}, {far, far, 0}, {-far, far, 0}});
        assertThat(rings.find()).isEqualTo(rings.slowly());
    }

    /** A ring of the first vertices, and what lies beyond its edges; its completions quickly, and slowly. */
    private static final class Rings {
        private final int[][] places;
        private int size;
        private int gap = NONE; // before the vertex of this number
        private int[] beyond = {};
        private Ring ring;

        Rings(int[][] places) {
            this.places = places;
            size = places.length;
        }

        /** A polygon about a point, with vertices beyond some of its edges. */
        static Rings random(Random random, int size, boolean flat) {
            int[][] places = new int[2 * size][3];
            int[] beyond = new int[size];
            for (int i = 0; i < 2 * size; i++) {
                double angle = 2 * Math.PI * (i % size + random.nextDouble()) / size;
                double radius = (i < size ? 100 : 200) * (1 + random.nextDouble());
                places[i][0] = (int) (radius * Math.cos(angle)) - 50;
                places[i][1] = (int) (radius * Math.sin(angle)) + 90;
                if (!flat) places[i][2] = random.nextInt(300) - 150;
            }
            for (int i = 0; i < size; i++) beyond[i] = random.nextInt(3) == 0 ? NONE : size + i;
            Rings rings = new Rings(places);
            rings.size = size;
            rings.beyond = beyond;
            return rings;
        }

        /** Begins with another vertex. */
        void turn(int steps) {
            int[][] before = places.clone();
            int[] beyondBefore = beyond.clone();
            for (int i = 0; i < size; i++) {
                places[i] = before[(i + steps) % size];
                beyond[i] = beyondBefore[(i + steps) % size];
            }
        }

        /** Goes the other way round. */
        void reverse() {
            int[][] before = places.clone();
            int[] beyondBefore = beyond.clone();
            for (int i = 0; i < size; i++) {
                places[i] = before[size - 1 - i];
                beyond[i] = beyondBefore[(2 * size - 2 - i) % size];
            }
        }

        void mirror() {
            for (int[] place : places) place[0] = -place[0];
        }

        /** Median and range of the first coordinate, then of the second. */
        double[] find() {
            LodMesh mesh = new LodMesh(false, false, false, places.length, places.length, places.length);
            for (int[] place : places) {
                int fan = mesh.addFan(mesh.addVertex());
                System.arraycopy(place, 0, mesh.places(), 4 * fan, 3);
            }
            ring = new Ring(mesh);
            List<Integer> list = new ArrayList<>();
            for (int i = 0; i < size; i++) list.add(i);
            if (gap >= 0) list.add(gap, NONE);
            ring.measure(list.stream().mapToInt(v -> v).toArray(), 0, list.size());
            Completions completions = new Completions(mesh, ring);
            // as they lie in a lane: other rings' before and behind them
            int[] lane = new int[LARGEST + 20];
            Arrays.fill(lane, NONE);
            System.arraycopy(beyond, 0, lane, 4, beyond.length);
            completions.find(lane, 4);
            return new double[] {
                completions.firstMedian(),
                completions.firstRange(),
                completions.secondMedian(),
                completions.secondRange()
            };
        }

        void expect(double firstMedian, double firstRange, double secondMedian, double secondRange) {
            double[] expected = {firstMedian, firstRange, secondMedian, secondRange};
            assertThat(find()).isEqualTo(expected);
            assertThat(slowly()).isEqualTo(expected);
        }

        /** The same, for the axes of the ring last found: all completions as numbers, sorted. */
        double[] slowly() {
            long[] first = sorted(ring.first);
            long[] second = sorted(ring.second);
            return new double[] {median(first), range(first), median(second), range(second)};
        }

        int count() {
            return completions(0).size();
        }

        private long[] sorted(int axis) {
            return completions(axis).stream().mapToLong(x -> x).sorted().toArray();
        }

        /** Twice the completions. */
        private List<Long> completions(int axis) {
            List<Long> found = new ArrayList<>();
            for (int i = 0; i < size; i++) found.add(2 * (at(i - 1, axis) + at(i + 1, axis) - at(i, axis)));
            for (int i = 0; i < size; i++) {
                for (int j = i + 1; j < size; j++) {
                    int apart = Math.min(j - i, size - j + i);
                    if (apart == size / 2) found.add(at(i, axis) + at(j, axis));
                }
            }
            boolean reaches = gap < 0 && size <= SplitLane.FEW;
            for (int i = 0; reaches && i < beyond.length; i++) {
                if (beyond[i] != NONE) found.add(2 * (at(i, axis) + at(i + 1, axis) - places[beyond[i]][axis]));
            }
            return found;
        }

        private long at(int number, int axis) {
            return places[Math.floorMod(number, size)][axis];
        }

        private static double median(long[] twice) {
            int n = twice.length;
            return n % 2 == 1 ? twice[n / 2] / 2.0 : (twice[n / 2 - 1] + twice[n / 2]) / 4.0;
        }

        private static double range(long[] twice) {
            return (twice[3 * twice.length / 4] - twice[twice.length / 4]) / 2.0;
        }
    }
}
