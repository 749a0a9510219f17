package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** What glTF says of light, sides and opacity, in the pixel in the middle of a square without images. */
class DrawnSurfaceTest {
    private static final String HALF = "{'pbrMetallicRoughness':{'baseColorFactor':[1,0.5,0.1,0.5]}";

    @BeforeAll
    static void needsDisplay() {
        Requirement.display();
    }

    private static Color middle(MeshBuilder square, String material) {
        Mesh mesh = square.materials(List.of(new Material("m", List.of(), List.of(), material.replace('\'', '"'))))
                .build();
        BufferedImage picture = Pictures.drawn(mesh, mesh.bounds(), false);
        return new Color(picture.getRGB(Pictures.WIDTH / 2, Pictures.HEIGHT / 2), true);
    }

    private static MeshBuilder square() {
        return MeshBuilder.from(Shapes.texturedSquare("map_Kd")).textures(List.of());
    }

    /** Normals point to the viewer still, as they do in many files with turned faces. */
    private static MeshBuilder turned() {
        return square().faceWedges(new int[] {0, 2, 1, 0, 3, 2});
    }

    private static Color screen(double... light) {
        double[] toned = StudioShading.toned(light);
        int[] levels = new int[3];
        for (int k = 0; k < 3; k++) {
            double l = Math.max(0, Math.min(1, toned[k]));
            levels[k] = (int) Math.round(255 * (l <= .0031308 ? 12.92 * l : 1.055 * Math.pow(l, 1 / 2.4) - .055));
        }
        return new Color(levels[0], levels[1], levels[2]);
    }

    private static void assertClose(Color drawn, Color expected) {
        assertThat(drawn.getRed()).isBetween(expected.getRed() - 1, expected.getRed() + 1);
        assertThat(drawn.getGreen()).isBetween(expected.getGreen() - 1, expected.getGreen() + 1);
        assertThat(drawn.getBlue()).isBetween(expected.getBlue() - 1, expected.getBlue() + 1);
        assertThat(drawn.getAlpha()).isEqualTo(expected.getAlpha());
    }

    @Test
    void shouldShowAnUnlitColourAsItIsButForTheToneOfThePicture() {
        String unlit = "{'pbrMetallicRoughness':{'baseColorFactor':[%s]},'extensions':{'KHR_materials_unlit':{}}}";
        assertClose(middle(square(), unlit.formatted("0.2,0.4,0.05,1")), screen(.2, .4, .05));
        assertClose(middle(square(), unlit.formatted("1,1,1,1")), screen(1, 1, 1));
    }

    @Test
    void shouldAddStrongEmissionToABlackRoughMetal() {
        String glow = "{'pbrMetallicRoughness':{'baseColorFactor':[0,0,0,1]},'emissiveFactor':[0.2,0.1,0.4],"
                + "'extensions':{'KHR_materials_emissive_strength':{'emissiveStrength':4}}}";
        Color drawn = middle(square(), glow);
        Color least = screen(.8, .4, 1.6);
        // A metal that reflects nothing from straight ahead still has some gloss from aside.
        assertThat(drawn.getRed()).isBetween(least.getRed() - 1, least.getRed() + 6);
        assertThat(drawn.getGreen()).isBetween(least.getGreen() - 1, least.getGreen() + 12);
        assertThat(drawn.getBlue()).isBetween(least.getBlue() - 1, least.getBlue() + 6);
    }

    @Test
    void shouldShowTheBackOfFacesOnlyWhereTheMaterialHasTwoSides() {
        assertThat(middle(square(), "{}").getAlpha()).isEqualTo(255);
        assertThat(middle(turned(), "{}").getAlpha()).isZero();
        assertThat(middle(turned(), "{'doubleSided':true}").getAlpha()).isEqualTo(255);
        assertThat(middle(square(), "{'doubleSided':true}").getAlpha()).isEqualTo(255);
    }

    @Test
    void shouldTakeOpacityAsTheMaterialMeansIt() {
        assertThat(middle(square(), HALF + "}").getAlpha()).isEqualTo(255);
        assertThat(middle(square(), HALF + ",'alphaMode':'OPAQUE'}").getAlpha()).isEqualTo(255);
        assertThat(middle(square(), HALF + ",'alphaMode':'BLEND'}").getAlpha()).isBetween(127, 128);
        assertThat(middle(square(), HALF + ",'alphaMode':'MASK'}").getAlpha()).isEqualTo(255);
        assertThat(middle(square(), HALF + ",'alphaMode':'MASK','alphaCutoff':0.6}")
                        .getAlpha())
                .isZero();
    }

    @Test
    void shouldMultiplyLinearVertexColoursWithTheirOpacity() {
        int[] values = new int[16];
        float[] rgba = {.5f, .25f, 1, .5f};
        for (int i = 0; i < 16; i++) values[i] = Float.floatToIntBits(rgba[i % 4]);
        Channel colours = new Channel(Channel.Semantic.COLOUR, "COLOR_0", 4, Channel.Type.FLOAT32, values, null);
        MeshBuilder square = square().channels(List.of(colours));
        String unlit = "{'pbrMetallicRoughness':{'baseColorFactor':[0.4,0.4,0.4,1]},"
                + "'extensions':{'KHR_materials_unlit':{}}%s}";
        assertClose(middle(square, unlit.formatted("")), screen(.2, .1, .4));
        assertThat(middle(square, unlit.formatted(",'alphaMode':'BLEND'")).getAlpha())
                .isBetween(127, 128);
    }
}
