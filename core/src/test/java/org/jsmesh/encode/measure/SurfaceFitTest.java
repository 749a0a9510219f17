package org.jsmesh.encode.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.junit.jupiter.api.Test;

class SurfaceFitTest {
    private static final int SIDE = 24;
    private static final double UNIT = 1e-4;

    @Test
    void shouldBringCoarseLevelsOfAHillCloserToIt() {
        Mesh hill = hill(1);
        int[] coarse = grid(SIDE / 4);
        int[] middle = grid(SIDE / 12);
        int[] moves = fitter(hill).fit(List.of(middle, coarse), UNIT);
        float[] moved = hill.positions().clone();
        for (int i = 0; i < moved.length; i++) moved[i] += (float) (moves[i] * UNIT);
        DistanceMeter meter = new DistanceMeter(hill);
        for (int[] level : List.of(coarse, middle)) {
            double before =
                    meter.measure(hill.positions(), level, level.length / 3).mean();
            double after = meter.measure(moved, level, level.length / 3).mean();
            assertThat(after).isLessThan((level == coarse ? 0.93 : 0.83) * before); // the finer one counts more
        }
    }

    @Test
    void shouldMoveNothingInAPlane() {
        assertThat(fitter(hill(0)).fit(List.of(grid(6)), UNIT)).containsOnly(0);
    }

    @Test
    void shouldMoveOnlyVerticesOfTheLevels() {
        int[] moves = fitter(hill(1)).fit(List.of(grid(6)), UNIT);
        for (int v = 0; v < moves.length / 3; v++) {
            boolean isShared = v % (SIDE + 1) % 6 == 0 && v / (SIDE + 1) % 6 == 0;
            if (!isShared)
                assertThat(Arrays.copyOfRange(moves, 3 * v, 3 * v + 3)).containsOnly(0);
        }
        assertThat(moves[2]).isNotZero();
    }

    @Test
    void shouldChoosePlacesCloserToAHillThanRoundedOnes() {
        Mesh hill = hill(1);
        int[] level = grid(2);
        UnitGrid places = new UnitGrid(UNIT, new double[3], 6, null);
        int[] chosen = fitter(hill).fit(List.of(level), places);
        int[] rounded = fitter(hill).fit(List.of(level), UNIT);
        for (int i = 0; i < rounded.length; i++) {
            int cell = places.cell(hill.positions()[i], i % 3);
            if (rounded[i] != 0) rounded[i] = places.middleCell(cell + rounded[i] >> 6) - cell;
            if (chosen[i] != 0) assertThat(cell + chosen[i] & 63).isEqualTo(32);
        }
        assertThat(error(hill, level, chosen)).isLessThan(.95 * error(hill, level, rounded));
    }

    private static double error(Mesh original, int[] level, int[] moves) {
        float[] moved = original.positions().clone();
        for (int i = 0; i < moved.length; i++) moved[i] += (float) (moves[i] * UNIT);
        return new DistanceMeter(original)
                .measure(moved, level, level.length / 3)
                .mean();
    }

    private static SurfaceFit fitter(Mesh mesh) {
        return new SurfaceFit(
                mesh, new SurfacePoints(mesh.positions(), mesh.faceWedges()), new StageProgress(ProgressListener.NONE));
    }

    /** Two triangles for each square of a grid with steps of so many vertices. */
    private static int[] grid(int step) {
        int cells = SIDE / step;
        int[] triangles = new int[6 * cells * cells];
        int n = 0;
        for (int y = 0; y < SIDE; y += step) {
            for (int x = 0; x < SIDE; x += step) {
                int a = y * (SIDE + 1) + x;
                int b = a + step;
                int c = a + step * (SIDE + 1);
                for (int v : new int[] {a, b, c, b, c + step, c}) triangles[n++] = v;
            }
        }
        return triangles;
    }

    private static Mesh hill(double height) {
        float[] positions = new float[3 * (SIDE + 1) * (SIDE + 1)];
        for (int i = 0; i < positions.length / 3; i++) {
            double x = (double) (i % (SIDE + 1)) / SIDE;
            double y = (double) (i / (SIDE + 1)) / SIDE;
            positions[3 * i] = (float) x;
            positions[3 * i + 1] = (float) y;
            positions[3 * i + 2] = (float) (height * (x * x + y * y));
        }
        return new MeshBuilder().positions(positions).faceWedges(grid(1)).build();
    }
}
