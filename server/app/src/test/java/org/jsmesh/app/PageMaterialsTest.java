package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.web.testing.Browser;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * What MTL and OBJ say of colour, light and opacity, as the page draws it: pixels of a square of which each half says
 * something else.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Timeout(300)
class PageMaterialsTest {
    private static final String SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
    private static final String FACE = "f 1 2 3 4\n";
    private static final String TEXTURED = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
    private static final int SIDE = 200;
    private static final int CLEAR = 0;

    @TempDir
    static Path folder;

    private Browser browser;
    private ModelStore store;
    private JsmServer server;

    @BeforeAll
    void start() throws Exception {
        Path models = Files.createDirectory(folder.resolve("models"));
        painted(models, "tr", "Kd 1 0 0\nTr .5");
        painted(models, "glow", "Kd 0 0 0\nKe 0 .9 .9");
        painted(models, "leaf", "Kd 1 0 0\nmap_Kd leaf.png\nmap_d leaf.png");
        painted(models, "mask", "Kd 0 0 1\nmap_d mask.png");
        painted(models, "tga", "Kd 0 1 0\nmap_Kd halves.tga");
        painted(models, "missing", "Kd 0 1 0\nmap_Kd nowhere.png");
        half(models, "leaf.png", new Color(0, 255, 0, 0), new Color(0, 255, 0));
        half(models, "mask.png", Color.WHITE, Color.BLACK);
        Files.write(
                models.resolve("halves.tga"),
                new byte[] {0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 16, 0, 1, 0, 24, 0, -121, 0, 0, -1, -121, -1, 0, 0});
        String bytes = "v -1 -1 0 255 0 0\nv 1 -1 0 0 0 255\nv 1 1 0 0 0 255\nv -1 1 0 255 0 0\n";
        Files.writeString(models.resolve("bytes.obj"), bytes + FACE);
        StoreSettings settings = StoreSettings.of(models).withCache(folder.resolve("cache"));
        store = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
        server = JsmServer.start(ServerSettings.defaults(), store);
        browser = new Browser(Files.createDirectory(folder.resolve("profile")));
    }

    @AfterAll
    void stop() throws IOException {
        if (browser != null) browser.close();
        if (server != null) server.close();
        if (store != null) store.close();
    }

    private static void painted(Path models, String name, String statements) throws IOException {
        Files.writeString(
                models.resolve(name + ".obj"),
                "mtllib " + name + ".mtl\n" + SQUARE + TEXTURED + "usemtl m\nf 1/1 2/2 3/3 4/4\n");
        Files.writeString(models.resolve(name + ".mtl"), "newmtl m\n" + statements + "\n");
    }

    private static void half(Path models, String name, Color left, Color right) throws IOException {
        BufferedImage image = new BufferedImage(64, 64, BufferedImage.TYPE_INT_ARGB);
        for (int i = 0; i < 64 * 64; i++) image.setRGB(i % 64, i / 64, (i % 64 < 32 ? left : right).getRGB());
        ImageIO.write(image, "png", models.resolve(name).toFile());
    }

    /** Alpha, red, green, blue in the middle of each half. */
    private Color[] halves(String name) {
        browser.open(server.uri().resolve("?shading=matte&m=" + name));
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        browser.call("await jsm.complete();");
        browser.await("jsm.texturesLoading === 0");
        BufferedImage picture = browser.snapshot(SIDE, SIDE);
        return new Color[] {
            new Color(picture.getRGB(SIDE * 3 / 10, SIDE / 2), true),
            new Color(picture.getRGB(SIDE * 7 / 10, SIDE / 2), true)
        };
    }

    private static void shouldBe(Color colour, int red, int green, int blue) {
        assertThat(colour.getAlpha()).isEqualTo(255);
        int[] parts = {colour.getRed(), colour.getGreen(), colour.getBlue()};
        int[] wanted = {red, green, blue};
        for (int k = 0; k < 3; k++) {
            if (wanted[k] == 0) assertThat(parts[k]).as(colour.toString()).isLessThan(40);
            else assertThat(parts[k]).as(colour.toString()).isGreaterThan(120);
        }
    }

    @Test
    void shouldShowColoursFrom0To255InTheirRange() {
        Color[] halves = halves("bytes");
        for (Color colour : halves) assertThat(colour.getGreen()).isLessThan(40);
        assertThat(halves[0].getRed()).isGreaterThan(halves[0].getBlue());
        assertThat(halves[1].getBlue()).isGreaterThan(halves[1].getRed());
        assertThat(halves[0].getRed()).isBetween(100, 250);
    }

    @Test
    void shouldCutHolesByTheAlphaOfAnImageAndByAMask() {
        Color[] leaf = halves("leaf");
        assertThat(leaf[0].getAlpha()).isEqualTo(CLEAR);
        shouldBe(leaf[1], 0, 255, 0);
        Color[] mask = halves("mask");
        shouldBe(mask[0], 0, 0, 255);
        assertThat(mask[1].getAlpha()).isEqualTo(CLEAR);
    }

    @Test
    void shouldLetHalfOfTheLightThroughAtTrOfOneHalf() {
        Color colour = halves("tr")[0];
        assertThat(colour.getAlpha()).isBetween(120, 136);
        assertThat(colour.getRed()).isGreaterThan(colour.getGreen() + 80);
    }

    @Test
    void shouldShowEmissionOfABlackSurface() {
        shouldBe(halves("glow")[0], 0, 255, 255);
    }

    @Test
    void shouldShowATgaImage() {
        Color[] halves = halves("tga");
        shouldBe(halves[0], 255, 0, 0);
        shouldBe(halves[1], 0, 0, 255);
    }

    @Test
    void shouldShowTheColourOfAMaterialWhoseImageIsMissing() {
        shouldBe(halves("missing")[0], 0, 255, 0);
        assertThat(browser.consoleErrors()).isEmpty();
    }
}
