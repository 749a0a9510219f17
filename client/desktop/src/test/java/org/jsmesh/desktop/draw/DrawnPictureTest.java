package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.studio.ContactShadow;
import org.jsmesh.studio.Ground;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.picture.PictureComparison;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * What OpenGL draws against what the software rasteriser draws. Stated tolerance: silhouettes agree to 99%
 * (intersection over union), colours to 1 of 255 in the mean over the silhouette; a textured picture to 2, as the two
 * filter images differently.
 */
class DrawnPictureTest {
    @BeforeAll
    static void needsDisplay() {
        Requirement.display();
    }

    @Test
    void shouldDrawAPlainMesh() throws IOException {
        assertAgrees("plain", Shapes.torus(90, 30), 1);
    }

    @Test
    void shouldDrawACubeWithFlatFaces() throws IOException {
        Mesh cube = Shapes.cube();
        assertAgrees("cube", cube, 1);
        BufferedImage drawn = Pictures.drawn(cube, cube.bounds(), false);
        BufferedImage smooth = Pictures.expected(cube, -1, cube.bounds());
        assertThat(PictureComparison.meanDifference(drawn, smooth, PictureComparison.opaque(drawn)))
                .isGreaterThan(10);
    }

    /** In float32 the vertices of this model would lie in a few planes. */
    @Test
    void shouldDrawAModelInMapCoordinatesAsAtTheOrigin() throws Exception {
        Mesh near = Shapes.torus(90, 30);
        double[] shifted = new double[3 * near.vertices()];
        for (int i = 0; i < shifted.length; i++)
            shifted[i] = near.positions()[i] / 1024.0 + (i % 3 == 0 ? 450_000 : i % 3 == 1 ? 5_411_000 : 0);
        Mesh far = MeshBuilder.from(near).positions(shifted).build();
        byte[] archive = new MeshEncoder(EncoderSettings.defaults())
                .encode(far, ProgressListener.NONE)
                .bytes();
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, archive.length);
        BufferedImage drawn = Pictures.drawn(decoder.mesh(), decoder.header().bounds(), false);
        Pictures.assertAgree(drawn, Pictures.expected(near, near.bounds()), 1);
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
    void shouldDrawTheMaterialUntilItsTextureArrives() throws IOException {
        Mesh square = Shapes.texturedSquare("map_Kd");
        Mesh waiting = MeshBuilder.from(square).textures(List.of()).build();
        BufferedImage drawn = Pictures.drawn(waiting, square.bounds(), false);
        BufferedImage expected = Pictures.expected(waiting, square.bounds());
        BitSet silhouette = PictureComparison.opaque(expected);
        assertThat(Pictures.likeness(drawn, expected)).isGreaterThan(.99);
        silhouette.and(PictureComparison.opaque(drawn));
        assertThat(PictureComparison.meanDifference(drawn, expected, silhouette))
                .isLessThan(1);
        assertThat(new Color(drawn.getRGB(Pictures.WIDTH / 2, Pictures.HEIGHT / 2)))
                .isNotEqualTo(Color.WHITE);
    }

    @Test
    void shouldDrawTheGroundBehindTheModel() throws IOException {
        Mesh mesh = Shapes.torus(20, 10);
        BufferedImage picture = Pictures.drawn(mesh, mesh.bounds(), true);
        Pictures.keep("ground", picture);
        assertThat(PictureComparison.opaque(picture).cardinality()).isEqualTo(Pictures.WIDTH * Pictures.HEIGHT);
        for (int y : new int[] {0, 3, Pictures.HEIGHT - 1}) {
            for (int x : new int[] {0, Pictures.WIDTH / 2, Pictures.WIDTH - 1}) {
                double[] ground = Ground.colour((x + .5) / Pictures.WIDTH, (y + .5) / Pictures.HEIGHT);
                Color drawn = new Color(picture.getRGB(x, y));
                assertThat(new double[] {drawn.getRed(), drawn.getGreen(), drawn.getBlue()})
                        .as(x + ", " + y)
                        .containsExactly(ground, within(1.));
            }
        }
    }

    @Test
    void shouldDarkenTheGroundBelowTheModelAlone() {
        Mesh torus = Shapes.torus(20, 10);
        BufferedImage bare = Pictures.drawn(torus, torus.bounds(), false);
        BufferedImage picture = Pictures.drawn(torus, torus.bounds(), true);
        Framing framing = Framing.of(torus.bounds(), UpAxis.UNKNOWN);
        ContactShadow shadow = Scene.of(torus, Pictures.CREASE, false, framing, new TextureImages())
                .shadow();
        double[] eye = Camera.framing(framing, Pictures.WIDTH, Pictures.HEIGHT).eye();
        int dark = 0;
        for (int y = 0; y < Pictures.HEIGHT; y++) {
            for (int x = 0; x < Pictures.WIDTH; x++) {
                if (bare.getRGB(x, y) != 0) continue;
                double light = 1 - shadowAt(x, y, eye, shadow);
                double expected = light * Ground.colour((x + .5) / Pictures.WIDTH, (y + .5) / Pictures.HEIGHT)[0];
                assertThat((double) (picture.getRGB(x, y) >> 16 & 255)).isCloseTo(expected, within(2.));
                if (light < .8) dark++;
            }
        }
        assertThat(dark).isGreaterThan(300);
    }

    private static double shadowAt(int x, int y, double[] eye, ContactShadow shadow) {
        double slope = Math.tan(Camera.FIELD_OF_VIEW / 2);
        double across = (2 * (x + .5) - Pictures.WIDTH) / Pictures.HEIGHT * slope;
        double upwards = (1 - 2 * (y + .5) / Pictures.HEIGHT) * slope;
        double length = Math.sqrt(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]);
        double level = Math.hypot(eye[0], eye[2]);
        double down = (-eye[1] + upwards * level) / length;
        if (down >= 0) return 0;
        double ahead = (-level - upwards * eye[1]) / length; // along the ground, away from the eye
        double t = (shadow.height() - eye[1]) / down;
        double sin = eye[0] / level;
        double cos = eye[2] / level;
        return shadow.at(eye[0] + t * (ahead * sin + across * cos), eye[2] + t * (ahead * cos - across * sin));
    }

    private static void assertAgrees(String name, Mesh mesh, double tolerance) throws IOException {
        BufferedImage drawn = Pictures.drawn(mesh, mesh.bounds(), false);
        BufferedImage expected = Pictures.expected(mesh, mesh.bounds());
        Pictures.keep(name + "-opengl", drawn);
        Pictures.keep(name + "-expected", expected);
        Pictures.assertAgree(drawn, expected, tolerance);
    }
}
