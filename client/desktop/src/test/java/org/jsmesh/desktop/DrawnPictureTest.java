package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
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
    void shouldDrawABackgroundBehindTheModel() {
        Mesh mesh = Shapes.torus(20, 10);
        BufferedImage picture = Pictures.drawn(mesh, mesh.bounds(), true);
        assertThat(PictureComparison.opaque(picture).cardinality()).isEqualTo(Pictures.WIDTH * Pictures.HEIGHT);
        assertThat(picture.getRGB(0, 0) & 255).isGreaterThan(picture.getRGB(0, Pictures.HEIGHT - 1) & 255);
    }

    private static void assertAgrees(String name, Mesh mesh, double tolerance) throws IOException {
        BufferedImage drawn = Pictures.drawn(mesh, mesh.bounds(), false);
        BufferedImage expected = Pictures.expected(mesh, mesh.bounds());
        Pictures.keep(name + "-opengl", drawn);
        Pictures.keep(name + "-expected", expected);
        Pictures.assertAgree(drawn, expected, tolerance);
    }
}
