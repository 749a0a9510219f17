package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * Panes of red and blue glass that no order of their faces puts into the right order: sorted by their middles, they
 * make stripes.
 */
class DrawnGlassTest {
    private static final Framing FRAMING = Framing.of(new float[] {-1, -1, -1, 1, 1, 1}, UpAxis.UNKNOWN);
    private static final Camera FRONT = Camera.framing(FRAMING, Pictures.WIDTH, Pictures.HEIGHT);
    private static final Camera BACK = FRONT.orbit(Math.PI, 0);
    private static final int STRIPS = 16;
    private static final int OPAQUE = 2;

    @BeforeAll
    static void needsDisplay() {
        Requirement.display();
    }

    private static Material glass(String colour, double opacity) {
        return new Material(
                "glass",
                List.of(),
                List.of(),
                "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[" + colour + "," + opacity
                        + "]},\"alphaMode\":\"" + (opacity < 1 ? "BLEND" : "OPAQUE")
                        + "\",\"doubleSided\":true,\"extensions\":{\"KHR_materials_unlit\":{}}}");
    }

    /** A pane from x = −1 to 1 whose z goes from one number to another, cut into strips. */
    private record Pane(double from, double to, int strips, int material) {}

    private static Mesh mesh(Pane... panes) {
        int strips = 0;
        for (Pane pane : panes) strips += pane.strips;
        float[] positions = new float[12 * strips];
        int[] corners = new int[6 * strips];
        int[] materials = new int[2 * strips];
        int strip = 0;
        for (Pane pane : panes) {
            for (int s = 0; s < pane.strips; s++, strip++) {
                for (int k = 0; k < 4; k++) {
                    double x = 2. * (s + (k & 1)) / pane.strips - 1;
                    positions[12 * strip + 3 * k] = (float) x;
                    positions[12 * strip + 3 * k + 1] = k < 2 ? -1 : 1;
                    positions[12 * strip + 3 * k + 2] = (float) (pane.from + (x + 1) / 2 * (pane.to - pane.from));
                }
                int v = 4 * strip;
                System.arraycopy(new int[] {v, v + 1, v + 3, v, v + 3, v + 2}, 0, corners, 6 * strip, 6);
                materials[2 * strip] = materials[2 * strip + 1] = pane.material;
            }
        }
        return new MeshBuilder()
                .positions(positions)
                .faceWedges(corners)
                .faceMaterials(materials)
                .materials(List.of(glass("0.5,0,0", .5), glass("0,0,0.5", .5), glass("0,0.5,0", 1)))
                .build();
    }

    private static BufferedImage drawn(Mesh mesh, Camera camera) {
        Scene scene = Scene.of(mesh, Pictures.CREASE, false, FRAMING, new TextureImages());
        return Screenshot.take(scene, camera, Pictures.WIDTH, Pictures.HEIGHT, false);
    }

    /** What a place of the model is drawn as. */
    private static Color at(BufferedImage picture, Camera camera, double x, double y, double z) {
        float[] p = FRAMING.toUnit(new float[] {(float) x, (float) y, (float) z});
        double[] v = camera.view();
        double[] eye = new double[3];
        for (int k = 0; k < 3; k++) eye[k] = v[k] * p[0] + v[4 + k] * p[1] + v[8 + k] * p[2] + v[12 + k];
        double scale = Pictures.HEIGHT / 2. / Math.tan(Camera.FIELD_OF_VIEW / 2) / -eye[2];
        return new Color(
                picture.getRGB(
                        (int) (Pictures.WIDTH / 2. + scale * eye[0]), (int) (Pictures.HEIGHT / 2. - scale * eye[1])),
                true);
    }

    private static void assertIs(Color drawn, boolean isRedFirst) {
        // The first layer has half of the light, the second one a quarter.
        assertThat(drawn.getAlpha()).isCloseTo(191, within(1));
        int first = isRedFirst ? drawn.getRed() : drawn.getBlue();
        int second = isRedFirst ? drawn.getBlue() : drawn.getRed();
        assertThat((double) first / second).isCloseTo(2, within(.1));
    }

    @Test
    void shouldDrawAPaneCloseBehindAnotherWithoutStripes() throws IOException {
        Mesh mesh = mesh(new Pane(.52, -.48, STRIPS, 0), new Pane(.5, -.5, 1, 1));
        for (Camera camera : List.of(FRONT, BACK)) {
            BufferedImage picture = drawn(mesh, camera);
            Pictures.keep("panes-" + (camera == FRONT ? "front" : "back"), picture);
            for (double x = -.8; x < .9; x += .05) assertIs(at(picture, camera, x, 0, -x / 2), camera == FRONT);
        }
    }

    @Test
    void shouldDrawPanesThatGoThroughOneAnother() throws IOException {
        BufferedImage picture = drawn(mesh(new Pane(.3, -.3, 1, 0), new Pane(-.3, .3, 1, 1)), FRONT);
        Pictures.keep("panes-through", picture);
        for (double y = -.6; y < .7; y += .2) {
            assertIs(at(picture, FRONT, -.3, y, .1), true);
            assertIs(at(picture, FRONT, .3, y, .1), false);
        }
    }

    @Test
    void shouldSortFacesWhereTheGraphicsCardHasNoLayers() {
        Mesh mesh = mesh(new Pane(.4, .4, 3, 0), new Pane(-.4, -.4, 5, 1));
        for (Camera camera : List.of(FRONT, BACK)) {
            BufferedImage picture = Screenshot.draw(Pictures.WIDTH, Pictures.HEIGHT, gl -> {
                SceneRenderer renderer = new SceneRenderer(gl, new LiveScene(), false);
                renderer.upload(gl, Scene.of(mesh, Pictures.CREASE, false, FRAMING, new TextureImages()));
                renderer.draw(gl, camera, Pictures.WIDTH, Pictures.HEIGHT, false, DrawStyle.defaults());
            });
            for (double x = -.4; x < .5; x += .1) assertIs(at(picture, camera, x, 0, 0), camera == FRONT);
        }
    }

    @Test
    void shouldHideGlassBehindAWallAndShowTheWallBehindGlass() {
        BufferedImage behind = drawn(mesh(new Pane(0, 0, 1, OPAQUE), new Pane(-.2, -.2, 1, 0)), FRONT);
        assertThat(at(behind, FRONT, 0, 0, 0))
                .matches(c -> c.getRed() < 60 && c.getGreen() > 100 && c.getAlpha() == 255);
        BufferedImage before = drawn(mesh(new Pane(0, 0, 1, OPAQUE), new Pane(.2, .2, 1, 0)), FRONT);
        Color half = at(before, FRONT, 0, 0, .2);
        assertThat(half.getRed()).isBetween(70, 110);
        assertThat(half.getGreen()).isBetween(40, 110);
        assertThat(half.getAlpha()).isEqualTo(255);
    }
}
