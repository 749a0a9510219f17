package org.jsmesh.test.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.util.BitSet;
import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.junit.jupiter.api.Test;

class SoftwareRasteriserTest {
    private static final View FRONT =
            new View(new double[] {0, 0, 4}, new double[3], new double[] {0, 1, 0}, 2 * Math.toDegrees(Math.atan(.5)));

    /** Two overlapping squares that face +z: a red one, half as wide, in front of a blue one. */
    private static Mesh squares() {
        return new MeshBuilder()
                .positions(new float[] {
                    -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, -.5f, -.5f, 1, .5f, -.5f, 1, .5f, .5f, 1, -.5f, .5f, 1
                })
                .faceWedges(new int[] {4, 5, 6, 4, 6, 7, 0, 1, 2, 0, 2, 3})
                .faceMaterials(new int[] {0, 0, 1, 1})
                .materials(List.of(
                        new Material("red", List.of(new Material.Parameter("Kd", 1, 0, 0)), List.of()),
                        new Material("blue", List.of(new Material.Parameter("Kd", 0, 0, .5f)), List.of())))
                .build();
    }

    @Test
    void shouldDrawNearFacesOverFarOnesAtTheirPlace() {
        BufferedImage picture = new SoftwareRasteriser(squares()).draw(FRONT, Light.FLAT, 120, 120);
        // At distance 4 the picture is 4 wide, so the blue square fills half of it; the red one, at distance 3, a
        // third.
        assertThat(picture.getRGB(60, 60)).isEqualTo(0xffff0000);
        assertThat(picture.getRGB(41, 79)).isEqualTo(0xffff0000);
        assertThat(picture.getRGB(38, 60)).isEqualTo(0xff000080);
        assertThat(picture.getRGB(31, 89)).isEqualTo(0xff000080);
        assertThat(picture.getRGB(28, 60)).isZero();
        assertThat(PictureComparison.opaque(picture).cardinality()).isEqualTo(60 * 60);
    }

    @Test
    void shouldLightTheSideThatIsSeen() {
        Light key = new Light(
                new double[3],
                new double[3],
                new double[] {1, 1, 1},
                new double[] {0, 0, 1},
                new double[3],
                new double[] {0, 0, 1},
                0,
                1);
        View behind = new View(new double[] {0, 0, -4}, new double[3], new double[] {0, 1, 0}, 60);
        BufferedImage front = new SoftwareRasteriser(squares()).draw(FRONT, key, 60, 60);
        BufferedImage back = new SoftwareRasteriser(squares()).draw(behind, key, 60, 60);
        assertThat(front.getRGB(30, 30)).isEqualTo(0xffff0000);
        assertThat(back.getRGB(30, 30)).isEqualTo(0xff000080);
    }

    @Test
    void shouldMeasureHowFarPicturesAgree() {
        BufferedImage a = new SoftwareRasteriser(squares()).draw(FRONT, Light.FLAT, 120, 120);
        View shifted =
                new View(new double[] {.5, 0, 4}, new double[] {.5, 0, 0}, new double[] {0, 1, 0}, FRONT.fieldOfView());
        BufferedImage b = new SoftwareRasteriser(squares()).draw(shifted, Light.FLAT, 120, 120);
        BitSet both = PictureComparison.opaque(a);
        assertThat(PictureComparison.intersectionOverUnion(both, PictureComparison.opaque(a)))
                .isEqualTo(1);
        assertThat(PictureComparison.meanDifference(a, a, both)).isZero();
        // The square of 60 pixels moves by 15.
        assertThat(PictureComparison.intersectionOverUnion(both, PictureComparison.opaque(b)))
                .isCloseTo(45.0 / 75, within(1e-9));
        assertThat(PictureComparison.meanDifference(a, b, both)).isGreaterThan(10);
        BufferedImage empty = new BufferedImage(120, 120, BufferedImage.TYPE_INT_ARGB);
        assertThat(PictureComparison.differing(a, empty, 5)).isEqualTo(both);
    }
}
