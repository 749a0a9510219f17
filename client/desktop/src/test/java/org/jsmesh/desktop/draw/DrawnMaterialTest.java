package org.jsmesh.desktop.draw;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Material.Parameter;
import org.jsmesh.mesh.Material.TextureReference;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Texture;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** What MTL says of colour, light and opacity, in pixels of a square of which each half says something else. */
class DrawnMaterialTest {
    private static final Parameter RED = new Parameter("Kd", 1, 0, 0);
    private static final Parameter BLACK = new Parameter("Kd", 0, 0, 0);

    @BeforeAll
    static void needsDisplay() {
        Requirement.display();
    }

    private static Color[] halves(MeshBuilder square) {
        Mesh mesh = square.build();
        BufferedImage picture = Pictures.drawn(mesh, mesh.bounds(), false);
        int y = Pictures.HEIGHT / 2;
        int middle = Pictures.WIDTH / 2;
        return new Color[] {
            new Color(picture.getRGB(middle - 50, y), true), new Color(picture.getRGB(middle + 50, y), true)
        };
    }

    private static MeshBuilder square(List<Parameter> parameters, TextureReference... textures) {
        return MeshBuilder.from(Shapes.texturedSquare("map_Kd"))
                .textures(List.of())
                .materials(List.of(new Material("m", parameters, List.of(textures))));
    }

    private static Texture half(String path, Color left, Color right) throws IOException {
        BufferedImage image = new BufferedImage(64, 64, BufferedImage.TYPE_INT_ARGB);
        for (int i = 0; i < 64 * 64; i++) image.setRGB(i % 64, i / 64, (i % 64 < 32 ? left : right).getRGB());
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return new Texture(path, out.toByteArray());
    }

    @Test
    void shouldCutHolesByTheAlphaOfAnImage() throws IOException {
        Texture leaf = half("a.png", new Color(0, 255, 0, 0), Color.GREEN);
        Color[] halves = halves(
                square(List.of(RED), new TextureReference("map_Kd", "a.png")).textures(List.of(leaf)));
        assertThat(halves[0].getAlpha()).isZero();
        assertThat(halves[1].getAlpha()).isEqualTo(255);
        assertThat(halves[1].getGreen()).isGreaterThan(halves[1].getRed() + 80);
    }

    @Test
    void shouldCutHolesByAMask() throws IOException {
        Texture mask = half("a.png", Color.WHITE, Color.BLACK);
        Color[] halves = halves(
                square(List.of(RED), new TextureReference("map_d", "a.png")).textures(List.of(mask)));
        assertThat(halves[0].getAlpha()).isEqualTo(255);
        assertThat(halves[0].getRed()).isGreaterThan(halves[0].getGreen() + 80);
        assertThat(halves[1].getAlpha()).isZero();
    }

    @Test
    void shouldBlendAnImageThatIsGlass() throws IOException {
        Color glass = new Color(255, 0, 0, 128);
        Color[] halves = halves(square(List.of(RED), new TextureReference("map_Kd", "a.png"))
                .textures(List.of(half("a.png", glass, Color.RED))));
        assertThat(halves[0].getAlpha()).isBetween(126, 130);
        assertThat(halves[1].getAlpha()).isEqualTo(255);
    }

    @Test
    void shouldShowOpacityOfTrAndLightOfKe() {
        assertThat(halves(square(List.of(RED, new Parameter("Tr", .5f))))[0].getAlpha())
                .isBetween(126, 130);
        Color glow = halves(square(List.of(BLACK, new Parameter("Ke", 0, .9f, .9f))))[0];
        assertThat(glow.getGreen()).isGreaterThan(220);
        assertThat(glow.getRed()).isLessThan(60);
    }

    @Test
    void shouldShowSkyInSmoothMetalThatLooksUp() {
        List<Color> seen = new ArrayList<>();
        for (float metal : new float[] {0, 1})
            seen.add(halves(square(List.of(RED, new Parameter("Pm", metal), new Parameter("Pr", .1f))))[0]);
        // A mirror shows the lights at one place, a matte surface everywhere.
        assertThat(seen.get(1).getRed()).isLessThan(seen.get(0).getRed() - 20);
        assertThat(seen.get(1).getRed()).isGreaterThan(30);
        assertThat(seen.get(1).getBlue()).isLessThan(20);
    }

    /** Each half of the image says another number; the light comes from the left, above and the front. */
    @Test
    void shouldTakeMetalRoughnessAndLightFromImages() throws IOException {
        Texture blackAndWhite = half("a.png", Color.BLACK, Color.WHITE);
        Parameter smooth = new Parameter("Pr", .1f);
        Color[] metal = halves(square(List.of(RED, smooth), new TextureReference("map_Pm", "a.png"))
                .textures(List.of(blackAndWhite)));
        // Metal has no colour but that of what it mirrors.
        assertThat(metal[0].getRed()).isGreaterThan(metal[1].getRed() + 20);
        Parameter mirror = new Parameter("Pm", 1);
        Color[] rough = halves(square(List.of(RED, mirror), new TextureReference("map_Pr", "a.png"))
                .textures(List.of(blackAndWhite)));
        assertThat(rough[1].getRed()).isGreaterThan(rough[0].getRed() + 20);
        Color[] glow = halves(
                square(List.of(BLACK), new TextureReference("map_Ke", "a.png")).textures(List.of(blackAndWhite)));
        assertThat(glow[0].getGreen()).isLessThan(60);
        assertThat(glow[1].getGreen()).isGreaterThan(220);
    }

    @Test
    void shouldTurnTheSurfaceAsANormalMapSays() throws IOException {
        Texture leftAndRight = half("a.png", new Color(40, 128, 200), new Color(215, 128, 200));
        Color[] halves = halves(
                square(List.of(RED), new TextureReference("norm", "a.png")).textures(List.of(leftAndRight)));
        // The lamp stands to the left.
        assertThat(halves[0].getRed()).isGreaterThan(halves[1].getRed() + 30);
        Texture upAndDown = half("a.png", new Color(128, 215, 200), new Color(128, 40, 200));
        halves = halves(
                square(List.of(RED), new TextureReference("norm", "a.png")).textures(List.of(upAndDown)));
        // And it stands above.
        assertThat(halves[0].getRed()).isGreaterThan(halves[1].getRed() + 30);
    }

    @Test
    void shouldRaiseTheSurfaceWhereABumpMapIsBright() throws IOException {
        BufferedImage slopes = new BufferedImage(64, 64, BufferedImage.TYPE_BYTE_GRAY);
        for (int i = 0; i < 64 * 64; i++) {
            int y = i / 64;
            slopes.getRaster().setSample(i % 64, y, 0, 255 * (y < 32 ? y : 63 - y) / 32);
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(slopes, "png", out);
        Mesh mesh = square(
                        List.of(new Parameter("Kd", .5f, 0, 0), new Parameter("map_Bump -bm", 40)),
                        new TextureReference("map_Bump", "a.png"))
                .textures(List.of(new Texture("a.png", out.toByteArray())))
                .build();
        BufferedImage picture = Pictures.drawn(mesh, mesh.bounds(), false);
        // A ridge in the middle: its upper side faces the lamp.
        assertThat(meanRed(picture, Pictures.HEIGHT / 2 - 40))
                .isGreaterThan(meanRed(picture, Pictures.HEIGHT / 2 + 40) + 20);
    }

    /** Heights of 8 bits make small steps, which a mean leaves out. */
    private static double meanRed(BufferedImage picture, int y) {
        double sum = 0;
        for (int i = 0; i < 400; i++)
            sum += picture.getRGB(Pictures.WIDTH / 2 - 10 + i % 20, y - 10 + i / 20) >> 16 & 255;
        return sum / 400;
    }

    @Test
    void shouldShowColoursFrom0To255InTheirRange() {
        int red = Float.floatToIntBits(255);
        int blue = Float.floatToIntBits(127);
        int[] values = {red, 0, 0, red, 0, blue, red, 0, blue, red, 0, 0};
        MeshBuilder square = square(List.of())
                .faceMaterials(new int[] {-1, -1})
                .channels(
                        List.of(new Channel(Channel.Semantic.COLOUR, "colour", 3, Channel.Type.FLOAT32, values, null)));
        Color[] halves = halves(square);
        assertThat(halves[0].getGreen()).isLessThan(60);
        assertThat(halves[0].getRed()).isGreaterThan(100);
        assertThat(halves[1].getBlue()).isBetween(halves[0].getBlue() + 10, halves[1].getRed() - 50);
    }
}
