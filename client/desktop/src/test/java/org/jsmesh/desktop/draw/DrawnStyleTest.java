package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.jsmesh.display.DisplaySlots;
import org.jsmesh.display.LiveStep;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.studio.Lighting;
import org.jsmesh.studio.LinearColour;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.picture.PictureComparison;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Each style in single pixels of shapes whose normals are known. */
class DrawnStyleTest {
    private static final DrawStyle PLAIN = DrawStyle.defaults();
    private static final int X = Pictures.WIDTH / 2;
    private static final int Y = Pictures.HEIGHT / 2;
    private static final Framing FRAMING = Framing.of(new float[] {-1, -1, -1, 1, 1, 1}, UpAxis.UNKNOWN);
    private static final Camera CAMERA = Camera.framing(FRAMING, Pictures.WIDTH, Pictures.HEIGHT);

    @BeforeAll
    static void needsDisplay() {
        Requirement.display();
    }

    /** Faces +z. Its triangles meet from the lower left to the upper right. */
    private static Mesh square() {
        return MeshBuilder.from(Shapes.texturedSquare("map_Kd"))
                .textures(List.of())
                .faceMaterials(new int[] {-1, -1})
                .materials(List.of())
                .channels(List.of())
                .build();
    }

    private static BufferedImage drawn(Mesh mesh, DrawStyle style) {
        Scene scene = Scene.of(mesh, Pictures.CREASE, false, FRAMING, new TextureImages());
        return Screenshot.take(scene, CAMERA, Pictures.WIDTH, Pictures.HEIGHT, false, style);
    }

    private static BufferedImage drawn(ErrorMap map, LiveStep live, byte[] levels, Shading shading) {
        return Screenshot.draw(Pictures.WIDTH, Pictures.HEIGHT, gl -> {
            LiveScene scene = new LiveScene();
            SceneRenderer renderer = new SceneRenderer(gl, scene);
            int[] places = {0, 1};
            scene.take(
                    new SceneStep(new ShownScene(), live, places, levels, Map.of(), Map.of(), false, null, () -> {}));
            while (!scene.isResting()) renderer.advance(gl, 1);
            renderer.show(gl, map);
            renderer.draw(gl, CAMERA, Pictures.WIDTH, Pictures.HEIGHT, false, PLAIN.withShading(shading));
            renderer.dispose(gl);
        });
    }

    /** The square in unit space. */
    private static LiveStep step() {
        float[] p = FRAMING.toUnit(new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
        int[] data = new int[12 + 6];
        for (int i = 0; i < 12; i++) data[i] = Float.floatToIntBits(p[i]);
        System.arraycopy(new int[] {0, 1, 2, 0, 2, 3}, 0, data, 12, 6);
        int[] ranges = {LiveStep.POSITIONS, 0, 12, LiveStep.INDICES, 0, 6};
        return new LiveStep(1, false, 4, 2, 2, ranges, data, new int[] {0, 0, 6}, DisplaySlots.of(List.of(), false));
    }

    private static void assertClose(BufferedImage picture, int x, int y, int[] expected) {
        Color drawn = new Color(picture.getRGB(x, y), true);
        assertThat(new int[] {drawn.getRed(), drawn.getGreen(), drawn.getBlue(), drawn.getAlpha()})
                .satisfies(found -> {
                    for (int k = 0; k < 3; k++) assertThat(found[k]).isCloseTo(expected[k], within(1));
                    assertThat(found[3]).isEqualTo(255);
                });
    }

    /** The formula of a matte surface that faces +z, in a colour of the scale. */
    private static int[] painted(double share) {
        double[] v = CAMERA.view();
        double[] n = {v[8], v[9], v[10]};
        double lamp = 0;
        double up = 0;
        for (int k = 0; k < 3; k++) {
            lamp += n[k] * Lighting.KEY_DIRECTION[k];
            up += n[k] * v[4 + k];
        }
        Color colour = Palette.of(share);
        int[] srgb = {colour.getRed(), colour.getGreen(), colour.getBlue()};
        int[] seen = new int[3];
        for (int k = 0; k < 3; k++) {
            double sky = Lighting.GROUND[k] + (.5 + .5 * up) * (Lighting.SKY[k] - Lighting.GROUND[k]);
            double l = 1.2 * LinearColour.linear(srgb[k] / 255f) * (sky + Lighting.KEY[k] * lamp) / Math.PI;
            l = Math.min(1, l);
            seen[k] = (int) Math.round(255 * (l <= .0031308 ? 12.92 * l : 1.055 * Math.pow(l, 1 / 2.4) - .055));
        }
        return seen;
    }

    @Test
    void shouldShowDirectionsAsColours() {
        double[] v = CAMERA.view();
        int[] expected = new int[3];
        for (int k = 0; k < 3; k++) expected[k] = (int) Math.round(255 * (.5 + .5 * v[8 + k]));
        assertClose(drawn(square(), PLAIN.withShading(Shading.NORMALS)), X, Y, expected);
    }

    @Test
    void shouldShowTheTrianglesOfASmoothShape() throws IOException {
        Mesh torus = Shapes.torus(24, 10);
        Framing framing = Framing.of(torus.bounds(), UpAxis.UNKNOWN);
        Camera camera = Camera.framing(framing, Pictures.WIDTH, Pictures.HEIGHT);
        Scene smooth = Scene.of(torus, -1, false, framing, new TextureImages());
        Scene sharp = Scene.of(torn(torus), -1, false, framing, new TextureImages());
        BufferedImage flat = Screenshot.take(
                smooth, camera, Pictures.WIDTH, Pictures.HEIGHT, false, PLAIN.withShading(Shading.FLAT));
        BufferedImage expected = Screenshot.take(sharp, camera, Pictures.WIDTH, Pictures.HEIGHT, false);
        BufferedImage round = Screenshot.take(smooth, camera, Pictures.WIDTH, Pictures.HEIGHT, false);
        Pictures.keep("flat", flat);
        assertThat(PictureComparison.meanDifference(flat, expected, PictureComparison.opaque(flat)))
                .isLessThan(1);
        assertThat(PictureComparison.meanDifference(flat, round, PictureComparison.opaque(flat)))
                .isGreaterThan(3);
    }

    @Test
    void shouldPaintEachTriangleInTheColourOfItsLevel() throws IOException {
        BufferedImage picture = drawn(null, step(), new byte[] {2, 8}, Shading.LEVELS);
        Pictures.keep("square-levels", picture);
        assertClose(picture, X + 20, Y + 12, painted(2 / 8.));
        assertClose(picture, X - 20, Y - 12, painted(1));
    }

    @Test
    void shouldPaintAWholeMeshOnlyWhereItsLevelsAreKnown() {
        Mesh square = square();
        Scene scene = Scene.of(square, Pictures.CREASE, false, FRAMING, new TextureImages());
        DrawStyle levels = PLAIN.withShading(Shading.LEVELS);
        BufferedImage unknown = Screenshot.take(scene, CAMERA, Pictures.WIDTH, Pictures.HEIGHT, false, levels);
        assertThat(unknown.getRGB(X, Y)).isEqualTo(drawn(square, PLAIN).getRGB(X, Y));
        Scene known = scene.withLevels(square, new byte[] {1, 4}, 5);
        BufferedImage picture = Screenshot.take(known, CAMERA, Pictures.WIDTH, Pictures.HEIGHT, false, levels);
        assertClose(picture, X + 20, Y + 12, painted(1 / 5.));
        assertClose(picture, X - 20, Y - 12, painted(4 / 5.));
    }

    @Test
    void shouldPaintDistancesUpToTheLargest() {
        float[] p = FRAMING.toUnit(new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0});
        ErrorMap even = new ErrorMap(p, new float[] {3, 3, 3, 1, 1, 1}, 4);
        BufferedImage picture = drawn(even, step(), new byte[2], Shading.ERROR);
        assertClose(picture, X + 20, Y + 12, painted(3 / 4.));
        assertClose(picture, X - 20, Y - 12, painted(1 / 4.));
        assertClose(drawn(null, step(), new byte[2], Shading.ERROR), X, Y, painted(0));
    }

    @Test
    void shouldDrawEdgesOverEveryShading() throws IOException {
        for (Shading shading : Shading.values()) {
            BufferedImage plain = drawn(square(), PLAIN.withShading(shading));
            BufferedImage wired = drawn(square(), PLAIN.withShading(shading).withWireframe(true));
            Pictures.keep("wire-" + shading, wired);
            double darkest = 1;
            for (int y = Y - 2; y <= Y + 2; y++)
                darkest = Math.min(darkest, (double) bright(wired, X, y) / bright(plain, X, y));
            assertThat(darkest).as("%s", shading).isLessThan(.7);
            for (int side = -1; side <= 1; side += 2)
                assertThat(wired.getRGB(X + 20 * side, Y + 12 * side))
                        .isEqualTo(plain.getRGB(X + 20 * side, Y + 12 * side));
        }
    }

    @Test
    void shouldHideTheEdgesBehindAFace() {
        Mesh cube = Shapes.cube();
        BufferedImage plain = drawn(cube, PLAIN);
        BufferedImage wired = drawn(cube, PLAIN.withWireframe(true));
        int different = 0;
        int all = 0;
        for (int y = 0; y < Pictures.HEIGHT; y++)
            for (int x = 0; x < Pictures.WIDTH; x++) {
                if (plain.getRGB(x, y) == 0) continue;
                all++;
                if (plain.getRGB(x, y) != wired.getRGB(x, y)) different++;
            }
        // Nine edges of three sides and a diagonal of each, of which hidden ones would be as many again.
        assertThat(different).isBetween(all / 50, all / 12);
    }

    /** Triangles that share no corners. */
    private static Mesh torn(Mesh mesh) {
        float[] positions = new float[9 * mesh.faces()];
        int[] corners = new int[3 * mesh.faces()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = i;
            System.arraycopy(mesh.positions(), 3 * mesh.wedgeVertices()[mesh.faceWedges()[i]], positions, 3 * i, 3);
        }
        return new MeshBuilder().positions(positions).faceWedges(corners).build();
    }

    private static int bright(BufferedImage picture, int x, int y) {
        Color c = new Color(picture.getRGB(x, y));
        return 1 + c.getRed() + c.getGreen() + c.getBlue();
    }
}
