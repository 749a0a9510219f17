package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.BitSet;
import javax.imageio.ImageIO;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.picture.Light;
import org.jsmesh.test.picture.PictureComparison;
import org.jsmesh.test.picture.SoftwareRasteriser;
import org.jsmesh.test.picture.View;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * What OpenGL draws against what the software rasteriser draws. Stated tolerance: silhouettes agree to 99% (intersection over union), colours to 1 of 255 in the
 * mean over the silhouette; a textured picture to 2, as the two filter images differently.
 */
class PictureTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 240;

    @BeforeAll
    static void needsDisplay() {
        Requirement.display();
    }

    @Test
    void shouldDrawAPlainMesh() throws IOException {
        assertAgrees("plain", Shapes.torus(90, 30), 1);
    }

    @Test
    void shouldDrawVertexColours() throws IOException {
        assertAgrees("colours", Shapes.colouredTorus(90, 30), 1);
    }

    @Test
    void shouldDrawMaterials() throws IOException {
        assertAgrees("materials", Shapes.paintedTorus(90, 30), 1);
    }

    @Test
    void shouldDrawTexturesOfBothConventions() throws IOException {
        assertAgrees("mtl", Shapes.texturedSquare("map_Kd"), 2);
        assertAgrees("gltf", Shapes.texturedSquare("baseColorTexture"), 2);
    }

    @Test
    void shouldDrawABackgroundBehindTheModel() {
        BufferedImage picture = picture(Shapes.torus(20, 10), true);
        assertThat(PictureComparison.opaque(picture).cardinality()).isEqualTo(WIDTH * HEIGHT);
        assertThat(picture.getRGB(0, 0) & 255).isGreaterThan(picture.getRGB(0, HEIGHT - 1) & 255);
    }

    private static void assertAgrees(String name, Mesh mesh, double tolerance) throws IOException {
        BufferedImage drawn = picture(mesh, false);
        View view = View.framing(mesh.bounds(), 30, 20, 35, .98, (double) WIDTH / HEIGHT);
        BufferedImage expected = new SoftwareRasteriser(mesh).draw(view, light(), WIDTH, HEIGHT);
        keep(name + "-opengl", drawn);
        keep(name + "-expected", expected);
        BitSet silhouette = PictureComparison.opaque(drawn);
        BitSet other = PictureComparison.opaque(expected);
        assertThat(silhouette.cardinality()).isBetween(WIDTH * HEIGHT / 20, WIDTH * HEIGHT);
        assertThat(PictureComparison.contrast(drawn, silhouette)).isGreaterThan(3);
        assertThat(PictureComparison.intersectionOverUnion(silhouette, other)).isGreaterThan(.99);
        silhouette.and(other);
        double difference = PictureComparison.meanDifference(drawn, expected, silhouette);
        assertThat(difference).isLessThan(tolerance);
    }

    private static BufferedImage picture(Mesh mesh, boolean background) {
        Framing framing = Framing.of(mesh.bounds());
        Scene scene = Scene.of(mesh, framing, new TextureImages());
        return Screenshot.take(scene, Camera.framing(framing, WIDTH, HEIGHT), WIDTH, HEIGHT, background);
    }

    /** The viewer's light, for the other renderer. */
    static Light light() {
        return new Light(
                doubles(Lighting.SKY),
                doubles(Lighting.GROUND),
                doubles(Lighting.KEY),
                doubles(Lighting.KEY_DIRECTION),
                doubles(Lighting.FILL),
                doubles(Lighting.FILL_DIRECTION),
                Lighting.HIGHLIGHT,
                Lighting.SHININESS);
    }

    private static double[] doubles(float[] values) {
        double[] d = new double[values.length];
        for (int i = 0; i < d.length; i++) d[i] = values[i];
        return d;
    }

    private static void keep(String name, BufferedImage picture) throws IOException {
        File folder = new File("target/pictures");
        folder.mkdirs();
        ImageIO.write(picture, "png", new File(folder, name + ".png"));
    }
}
