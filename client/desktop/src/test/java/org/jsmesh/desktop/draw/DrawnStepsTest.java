package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.display.LiveStep;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.picture.PictureComparison;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Pictures of a mesh of which only changes are brought to the graphics card, slice by slice. */
class DrawnStepsTest {
    private static final long SLICE = 20_000;

    @BeforeAll
    static void needsDisplay() {
        Requirement.display();
    }

    private static EncodedArchive encoded(Mesh mesh) {
        return new MeshEncoder(EncoderSettings.defaults()).encode(mesh, ProgressListener.NONE);
    }

    private static BufferedImage drawn(TestSteps test, int count, DrawStyle style) {
        Camera camera = Camera.framing(test.framing, Pictures.WIDTH, Pictures.HEIGHT);
        return Screenshot.draw(Pictures.WIDTH, Pictures.HEIGHT, gl -> {
            LiveScene live = new LiveScene();
            SceneRenderer renderer = new SceneRenderer(gl, live);
            for (SceneStep step : test.steps.subList(0, count)) {
                live.take(step);
                while (!live.isResting()) renderer.advance(gl, SLICE);
            }
            renderer.draw(gl, camera, Pictures.WIDTH, Pictures.HEIGHT, true, style);
            renderer.dispose(gl);
        });
    }

    private static BufferedImage whole(TestSteps test, int step) {
        Camera camera = Camera.framing(test.framing, Pictures.WIDTH, Pictures.HEIGHT);
        return Screenshot.take(test.whole(step), camera, Pictures.WIDTH, Pictures.HEIGHT, true);
    }

    private static void assertSame(BufferedImage drawn, BufferedImage expected) {
        assertThat(pixels(drawn)).isEqualTo(pixels(expected));
    }

    private static int[] pixels(BufferedImage picture) {
        return picture.getRGB(0, 0, Pictures.WIDTH, Pictures.HEIGHT, null, 0, Pictures.WIDTH);
    }

    private static void assertDrawsAsWhole(Mesh mesh) throws Exception {
        TestSteps test = new TestSteps(encoded(mesh), 5);
        assertThat(test.steps).hasSizeGreaterThan(2);
        int last = test.steps.size();
        assertSame(drawn(test, last, DrawStyle.defaults()), whole(test, last - 1));
        assertThat(test.taken).isEqualTo(last);
        // The shadow is cast anew when there is much more of the model, or all of it.
        assertSame(drawn(test, 1, DrawStyle.defaults()), whole(test, 0));
    }

    @Test
    void shouldDrawTheSamePictureAsAWholeMesh() throws Exception {
        assertDrawsAsWhole(Shapes.paintedTorus(80, 30));
    }

    @Test
    void shouldDrawTheSamePictureWhereThereIsNoRoomAtFirst() throws Exception {
        TestSteps test = new TestSteps(encoded(Shapes.paintedTorus(80, 30)), 5);
        SceneStep s = test.steps.get(0);
        ShownScene roomless = new ShownScene();
        roomless.arrays.expect(
                LiveStep.INDICES, 3 * test.steps.size() * s.live().places());
        test.steps.set(
                0,
                new SceneStep(
                        roomless,
                        s.live(),
                        s.newPlaces(),
                        s.newLevels(),
                        s.images(),
                        s.masks(),
                        s.isClosed(),
                        s.shadow(),
                        s.taken()));
        int last = test.steps.size();
        assertSame(drawn(test, last, DrawStyle.defaults()), whole(test, last - 1));
    }

    @Test
    void shouldDrawColoursOfVerticesAsAWholeMesh() throws Exception {
        assertDrawsAsWhole(Shapes.colouredTorus(60, 24));
    }

    @Test
    void shouldDrawGlassAsAWholeMesh() throws Exception {
        Mesh torus = Shapes.torus(60, 24);
        Material glass = new Material("glass", List.of(new Material.Parameter("d", .5f)), List.of());
        Mesh mesh = MeshBuilder.from(torus)
                .faceMaterials(new int[torus.faces()])
                .materials(List.of(glass))
                .build();
        TestSteps test = new TestSteps(encoded(mesh), 5);
        int last = test.steps.size();
        BufferedImage drawn = drawn(test, last, DrawStyle.defaults());
        BufferedImage expected = whole(test, last - 1);
        // Faces of one depth may come in another order.
        assertThat(PictureComparison.meanDifference(drawn, expected, PictureComparison.opaque(expected)))
                .isLessThan(.2);
    }

    @Test
    void shouldDrawTheStepBeforeUntilAllOfOneIsThere() throws Exception {
        TestSteps test = new TestSteps(encoded(Shapes.torus(90, 30)), 5);
        int middle = test.steps.size() / 2;
        Camera camera = Camera.framing(test.framing, Pictures.WIDTH, Pictures.HEIGHT);
        List<BufferedImage> pictures = new ArrayList<>();
        Screenshot.draw(Pictures.WIDTH, Pictures.HEIGHT, gl -> {
            LiveScene live = new LiveScene();
            SceneRenderer renderer = new SceneRenderer(gl, live);
            for (SceneStep step : test.steps.subList(0, middle)) live.take(step);
            while (!live.isResting()) renderer.advance(gl, SLICE);
            live.take(test.steps.get(middle));
            do {
                pictures.add(
                        renderer.picture(gl, camera, Pictures.WIDTH, Pictures.HEIGHT, false, DrawStyle.defaults()));
            } while (!renderer.advance(gl, SLICE));
            renderer.dispose(gl);
        });
        assertThat(pictures).hasSizeGreaterThan(3);
        for (BufferedImage picture : pictures)
            assertThat(Pictures.likeness(picture, pictures.get(0))).isGreaterThan(.9999);
    }

    @Test
    void shouldDrawAnotherModelThatComesAmidAStep() throws Exception {
        TestSteps first = new TestSteps(encoded(Shapes.torus(90, 30)), 5);
        TestSteps other = new TestSteps(encoded(Shapes.cube()), 5);
        Camera camera = Camera.framing(other.framing, Pictures.WIDTH, Pictures.HEIGHT);
        BufferedImage drawn = Screenshot.draw(Pictures.WIDTH, Pictures.HEIGHT, gl -> {
            LiveScene live = new LiveScene();
            SceneRenderer renderer = new SceneRenderer(gl, live);
            live.take(first.steps.get(0));
            while (!live.isResting()) renderer.advance(gl, SLICE);
            live.take(first.steps.get(1));
            renderer.advance(gl, 4);
            assertThat(live.unfinished()).isEqualTo(2);
            other.steps.forEach(live::take);
            while (!live.isResting()) renderer.advance(gl, SLICE);
            renderer.draw(gl, camera, Pictures.WIDTH, Pictures.HEIGHT, true, DrawStyle.defaults());
            renderer.dispose(gl);
        });
        assertSame(drawn, whole(other, other.steps.size() - 1));
    }

    @Test
    void shouldDrawAllAgainWithAnotherContext() throws Exception {
        TestSteps test = new TestSteps(encoded(Shapes.paintedTorus(60, 20)), 5);
        LiveScene live = new LiveScene();
        Camera camera = Camera.framing(test.framing, Pictures.WIDTH, Pictures.HEIGHT);
        Screenshot.draw(Pictures.WIDTH, Pictures.HEIGHT, gl -> {
            SceneRenderer renderer = new SceneRenderer(gl, live);
            test.steps.forEach(live::take);
            while (!live.isResting()) renderer.advance(gl, SLICE);
            renderer.dispose(gl);
        });
        BufferedImage again = Screenshot.draw(Pictures.WIDTH, Pictures.HEIGHT, gl -> {
            SceneRenderer renderer = new SceneRenderer(gl, live);
            renderer.draw(gl, camera, Pictures.WIDTH, Pictures.HEIGHT, true, DrawStyle.defaults());
            renderer.dispose(gl);
        });
        assertSame(again, whole(test, test.steps.size() - 1));
    }

    @Test
    void shouldPaintFacesByTheirLevels() throws Exception {
        TestSteps test = new TestSteps(encoded(Shapes.torus(90, 30)), 1);
        BufferedImage picture =
                drawn(test, test.steps.size(), DrawStyle.defaults().withShading(Shading.LEVELS));
        Pictures.keep("levels", picture);
        // From dark violet to yellow, so that red goes up with the level, and green more.
        int most = 0;
        for (int y = 0; y < Pictures.HEIGHT; y++)
            for (int x = 0; x < Pictures.WIDTH; x++) {
                int rgb = picture.getRGB(x, y);
                most = Math.max(most, (rgb >> 8 & 255) - (rgb & 255));
            }
        assertThat(most).isGreaterThan(100);
    }
}
