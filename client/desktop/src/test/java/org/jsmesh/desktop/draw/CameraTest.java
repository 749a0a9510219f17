package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.jsmesh.mesh.UpAxis;
import org.junit.jupiter.api.Test;

class CameraTest {
    private static final Framing BOX = Framing.of(new float[] {-3, 0, 1, 5, 2, 7}, UpAxis.UNKNOWN);

    @Test
    void shouldFrameAllCornersAndFillTheWindowOneWay() {
        for (int[] size : new int[][] {{800, 600}, {300, 900}, {1000, 200}}) {
            Camera camera = Camera.framing(BOX, size[0], size[1]);
            double most = 0;
            for (int corner = 0; corner < 8; corner++) {
                double[] p = project(
                        camera,
                        size,
                        (corner & 1) == 0 ? -BOX.halfX() : BOX.halfX(),
                        (corner & 2) == 0 ? -BOX.halfY() : BOX.halfY(),
                        (corner & 4) == 0 ? -BOX.halfZ() : BOX.halfZ());
                most = Math.max(most, Math.max(Math.abs(p[0]), Math.abs(p[1])));
                assertThat(p[2]).isBetween(-1.0, 1.0);
            }
            assertThat(most).isCloseTo(.98, within(1e-9));
        }
    }

    @Test
    void shouldLookAtTheTargetFromTheDistance() {
        Camera camera = new Camera(.7, -.3, 2.5, .1, .2, .3);
        double[] v = camera.view();
        double[] target = {.1, .2, .3};
        assertThat(row(v, 0, target)).isCloseTo(0, within(1e-12));
        assertThat(row(v, 1, target)).isCloseTo(0, within(1e-12));
        assertThat(row(v, 2, target)).isCloseTo(-2.5, within(1e-12));
        assertThat(row(v, 2, camera.eye())).isCloseTo(0, within(1e-12));
    }

    @Test
    void shouldStopShortOfThePolesWhenOrbiting() {
        Camera camera = Camera.framing(BOX, 100, 100).orbit(0, 10);
        assertThat(Math.toDegrees(camera.pitch())).isCloseTo(89, within(1e-9));
        assertThat(Math.toDegrees(camera.orbit(0, -20).pitch())).isCloseTo(-89, within(1e-9));
    }

    @Test
    void shouldKeepTheDistanceWithinLimitsWhenZooming() {
        Camera camera = Camera.framing(BOX, 100, 100);
        assertThat(camera.zoom(.5).distance()).isCloseTo(camera.distance() / 2, within(1e-12));
        assertThat(camera.zoom(1e-9).distance()).isPositive();
        assertThat(camera.zoom(1e9).distance()).isLessThan(100);
    }

    @Test
    void shouldMoveTheTargetWithThePointerWhenPanning() {
        int[] size = {640, 480};
        Camera camera = new Camera(.7, .3, 2.5, .1, .2, .3);
        double[] p = project(camera.pan(.25, -.125), size, .1, .2, .3);
        assertThat(p[0] * 640 / 480 / 2).isCloseTo(.25, within(1e-12));
        assertThat(p[1] / 2).isCloseTo(-.125, within(1e-12));
    }

    @Test
    void shouldKeepAPointInItsPlaceWhenZoomingAboutIt() {
        int[] size = {640, 480};
        Camera camera = new Camera(.7, .3, 2.5, .1, .2, .3);
        double[] about = {.4, -.2, .5};
        double[] before = project(camera, size, about[0], about[1], about[2]);
        for (double factor : new double[] {.5, 1.3, 1e-9, 1e9}) {
            double[] after = project(camera.zoom(factor, about), size, about[0], about[1], about[2]);
            assertThat(after[0]).isCloseTo(before[0], within(1e-9));
            assertThat(after[1]).isCloseTo(before[1], within(1e-9));
        }
        assertThat(camera.zoom(.5, about).distance()).isCloseTo(1.25, within(1e-12));
    }

    @Test
    void shouldFindThePointBehindAPlaceOfTheWindow() {
        int[] size = {640, 480};
        Camera camera = new Camera(.7, .3, 2.5, .1, .2, .3);
        double[] point = {.4, -.2, .5};
        double[] place = project(camera, size, point[0], point[1], point[2]);
        assertThat(camera.point(place[0], place[1], 640. / 480, camera.depth(point)))
                .containsExactly(point, within(1e-12));
    }

    @Test
    void shouldMoveAPointAtItsDepthWithThePointerWhenPanning() {
        int[] size = {640, 480};
        Camera camera = new Camera(.7, .3, 2.5, .1, .2, .3);
        double[] point = {.4, -.2, .5};
        double[] before = project(camera, size, point[0], point[1], point[2]);
        double[] after = project(camera.pan(.25, -.125, camera.depth(point)), size, point[0], point[1], point[2]);
        assertThat((after[0] - before[0]) * 640 / 480 / 2).isCloseTo(.25, within(1e-12));
        assertThat((after[1] - before[1]) / 2).isCloseTo(-.125, within(1e-12));
    }

    @Test
    void shouldTellHowLongTheDiagonalIsWhereItIsNearest() {
        Camera camera = new Camera(.7, .3, 4, 0, 0, 0);
        int[] size = {640, 480};
        double[] e = camera.eye();
        double[] v = camera.view(); // its second row points up in the picture
        double[] ends = new double[2];
        for (int i = 0; i < 2; i++) {
            int sign = 2 * i - 1;
            ends[i] = project(camera, size, e[0] / 4 + sign * v[1], e[1] / 4 + sign * v[5], e[2] / 4 + sign * v[9])[1];
        }
        assertThat(camera.diagonalPixels(480)).isCloseTo((ends[1] - ends[0]) / 2 * 480, within(1e-6));
        assertThat(new Camera(0, 0, .5, 0, 0, 0).diagonalPixels(480))
                .isPositive()
                .isFinite();
    }

    private static double[] project(Camera camera, int[] size, double x, double y, double z) {
        double[] v = camera.view();
        double[] world = {x, y, z};
        double[] eye = {row(v, 0, world), row(v, 1, world), row(v, 2, world)};
        double[] p = camera.projection(size[0], size[1]);
        double w = row(p, 3, eye);
        return new double[] {row(p, 0, eye) / w, row(p, 1, eye) / w, row(p, 2, eye) / w};
    }

    private static double row(double[] matrix, int row, double[] point) {
        return matrix[row] * point[0] + matrix[4 + row] * point[1] + matrix[8 + row] * point[2] + matrix[12 + row];
    }
}
