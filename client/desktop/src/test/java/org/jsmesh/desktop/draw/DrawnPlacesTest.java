package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.picture.PictureComparison;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Places of the model beneath places of the picture, and pictures of other sizes. */
class DrawnPlacesTest {
    private static final Mesh CUBE = Shapes.cube();
    private static final Framing FRAMING = Framing.of(CUBE.bounds(), UpAxis.UNKNOWN);
    private static final Camera CAMERA = Camera.framing(FRAMING, Pictures.WIDTH, Pictures.HEIGHT);
    private static final Scene SCENE = Scene.of(CUBE, Pictures.CREASE, false, FRAMING, new TextureImages());

    @BeforeAll
    static void needsDisplay() {
        Requirement.display();
    }

    @Test
    void shouldFindTheNearestPointBeneathAPlace() {
        List<double[]> found = new ArrayList<>();
        Screenshot.draw(Pictures.WIDTH, Pictures.HEIGHT, gl -> {
            SceneRenderer renderer = new SceneRenderer(gl);
            found.add(renderer.pick(gl, CAMERA, Pictures.WIDTH, Pictures.HEIGHT, 0, 0));
            renderer.upload(gl, SCENE);
            found.add(renderer.pick(gl, CAMERA, Pictures.WIDTH, Pictures.HEIGHT, 0, 0));
            found.add(renderer.pick(gl, CAMERA, Pictures.WIDTH, Pictures.HEIGHT, .2, -.3));
            found.add(renderer.pick(gl, CAMERA, Pictures.WIDTH, Pictures.HEIGHT, .98, .98));
        });
        assertThat(found.get(0)).isNull();
        assertThat(found.get(3)).isNull();
        double aspect = (double) Pictures.WIDTH / Pictures.HEIGHT;
        double[][] places = {{0, 0}, {.2, -.3}};
        for (int i = 0; i < 2; i++) {
            double[] point = found.get(1 + i);
            double side = FRAMING.halfX();
            double most = Math.max(Math.abs(point[0]), Math.max(Math.abs(point[1]), Math.abs(point[2])));
            assertThat(most).isCloseTo(side, within(1e-5));
            assertThat(CAMERA.point(places[i][0], places[i][1], aspect, CAMERA.depth(point)))
                    .containsExactly(point, within(1e-5));
            assertThat(CAMERA.depth(point)).isLessThan(CAMERA.distance());
        }
    }

    @Test
    void shouldDrawAPictureOfAnySizeBesideTheOneOnTheScreen() {
        List<BufferedImage> pictures = new ArrayList<>();
        BufferedImage screen = Screenshot.draw(Pictures.WIDTH, Pictures.HEIGHT, gl -> {
            SceneRenderer renderer = new SceneRenderer(gl);
            renderer.upload(gl, SCENE);
            pictures.add(renderer.picture(gl, CAMERA, 500, 300, true, DrawStyle.defaults()));
            renderer.draw(gl, CAMERA, Pictures.WIDTH, Pictures.HEIGHT, true, DrawStyle.defaults());
            pictures.add(renderer.picture(gl, CAMERA, 77, 501, false, DrawStyle.defaults()));
        });
        assertLike(pictures.get(0), Screenshot.take(SCENE, CAMERA, 500, 300, true));
        assertLike(pictures.get(1), Screenshot.take(SCENE, CAMERA, 77, 501, false));
        assertLike(screen, Screenshot.take(SCENE, CAMERA, Pictures.WIDTH, Pictures.HEIGHT, true));
    }

    private static void assertLike(BufferedImage drawn, BufferedImage expected) {
        assertThat(drawn.getWidth()).isEqualTo(expected.getWidth());
        assertThat(drawn.getHeight()).isEqualTo(expected.getHeight());
        assertThat(PictureComparison.meanDifference(drawn, expected, PictureComparison.opaque(expected)))
                .isLessThan(.5);
    }

    @Test
    void shouldSayWhichSizesThereAre() {
        Screenshot.draw(8, 8, gl -> {
            SceneRenderer renderer = new SceneRenderer(gl);
            assertThatThrownBy(() -> renderer.picture(gl, CAMERA, 1 << 20, 8, true, DrawStyle.defaults()))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("1048576 × 8")
                    .hasMessageContaining("choose a size");
        });
    }
}
