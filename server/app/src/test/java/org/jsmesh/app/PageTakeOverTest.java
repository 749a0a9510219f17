package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.test.picture.PictureComparison;
import org.jsmesh.web.testing.Browser;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The picture of the small renderer beside that of three.js, of the same mesh and camera: three.js takes over without a
 * jump. The mean difference is at most {@value #TOLERANCE} of 255.
 */
@Timeout(300)
class PageTakeOverTest {
    private static final double TOLERANCE = 1;

    /** In both renderers, one after the other. */
    private static final String DRAW = """
            const { Session } = await import('/modules/session/session.js');
            const { ModelView } = await import('/modules/viewer/model-view.js');
            const { fetchManifest } = await import('/modules/session/manifest.js');
            const host = document.body.appendChild(document.createElement('div'));
            host.style.cssText = 'position: fixed; inset: 0; width: 480px; height: 360px';
            const view = new ModelView(host, args[1]);
            view.shadow = 1;
            const takeOver = view.takeOver;
            view.takeOver = async () => {};
            const session = new Session();
            session.stage = view;
            session.open(await fetchManifest(new URL(`/m/${args[0]}/manifest.json`, location.href), 'default', () => {}),
                { decoder: 'auto', serverPlan: false });
            await session.complete();
            const size = { width: 480, height: 360 };
            await import('/modules/first/first-ground.js');
            for (let i = 0; i < 2; i++) await new Promise(requestAnimationFrame);
            const withGround = () => {
                view.render();
                return host.querySelector('canvas').toDataURL();
            };
            const pictures = [view.picture('image/png', size)];
            const grounds = [withGround()];
            if (view.isWhole) throw new Error('three.js drew the first picture');
            await takeOver.call(view);
            pictures.push(view.picture('image/png', size));
            grounds.push(withGround());
            if (!view.isWhole) throw new Error('three.js did not draw');
            session.dispose();
            view.dispose();
            host.remove();
            return [...pictures, ...grounds];
            """;

    @TempDir
    private Path folder;

    @Tag("long")
    @Test
    void shouldShowTheSameAsBefore() throws Exception {
        Path models = Files.createDirectory(folder.resolve("models"));
        GrainyTorus.write(models.resolve("coloured.ply"), 400, 110);
        FarScan.write(models.resolve("plain.obj"), 60, -10, -10, 3);
        Files.writeString(models.resolve("ball.obj"), ball());
        try (ModelStore store = new ModelStore(
                        StoreSettings.of(models).withCache(folder.resolve("cache")),
                        new ModelFilesEncoder(EncoderSettings.defaults()));
                JsmServer server = JsmServer.start(ServerSettings.defaults(), store);
                Browser browser = new Browser(Files.createDirectory(folder.resolve("profile")))) {
            browser.open(server.uri());
            for (String shading : List.of("smooth", "flat", "matte")) compare(browser, "coloured", shading);
            compare(browser, "plain", "smooth");
            for (BufferedImage picture : compare(browser, "ball", "smooth"))
                assertThat(darkDots(picture))
                        .as("dark dots along the silhouette")
                        .isLessThan(10);
            assertThat(browser.consoleErrors()).isEmpty();
        }
    }

    private static List<BufferedImage> compare(Browser browser, String model, String shading) throws Exception {
        List<?> pictures = (List<?>) browser.call(DRAW, model, shading);
        BufferedImage first = picture((String) pictures.get(0));
        BufferedImage three = picture((String) pictures.get(1));
        PagePictures.keep("take-over-" + model + "-" + shading, PagePictures.beside(first, three));
        PagePictures.assertAgree(first, three, .999, TOLERANCE);
        BitSet edges = PictureComparison.differing(first, three, 40);
        assertThat(edges.cardinality())
                .as(model + ", " + shading + ": pixels that jump")
                .isLessThan(20);
        compareGround(model, shading, picture((String) pictures.get(2)), picture((String) pictures.get(3)), three);
        return List.of(first, three);
    }

    /** The shadow is there with both, as dark. */
    private static void compareGround(
            String model, String shading, BufferedImage first, BufferedImage three, BufferedImage bare)
            throws Exception {
        PagePictures.keep("take-over-ground-" + model + "-" + shading, PagePictures.beside(first, three));
        int dark = 0;
        int others = 0; // a silhouette may lie a hair beside the other's
        for (int i = 0; i < bare.getWidth() * bare.getHeight(); i++) {
            int x = i % bare.getWidth();
            int y = i / bare.getWidth();
            if (bare.getRGB(x, y) != 0) continue;
            int alpha = three.getRGB(x, y) >>> 24;
            if (Math.abs((first.getRGB(x, y) >>> 24) - alpha) > 2) others++;
            if (alpha > 40) dark++;
        }
        assertThat(others)
                .as(model + ", " + shading + ": pixels of another shadow")
                .isLessThan(20);
        if (shading.equals("matte")) assertThat(dark).isZero();
        else assertThat(dark).as(model + ": pixels of the shadow").isGreaterThan(50);
    }

    /**
     * Pixels of the edge that are darker than the surface beside them, as where a face is seen from behind by mistake.
     */
    private static int darkDots(BufferedImage picture) {
        int dots = 0;
        for (int y = 1; y + 1 < picture.getHeight(); y++) {
            for (int x = 1; x + 1 < picture.getWidth(); x++) {
                int alpha = picture.getRGB(x, y) >>> 24;
                if (alpha == 0 || alpha == 255) continue;
                int column = x - 1;
                int row = y - 1;
                int[] beside = IntStream.range(0, 9)
                        .map(i -> picture.getRGB(column + i % 3, row + i / 3))
                        .filter(argb -> argb >>> 24 == 255)
                        .map(PageTakeOverTest::brightness)
                        .sorted()
                        .toArray();
                if (beside.length > 2 && brightness(picture.getRGB(x, y)) < beside[1] - 25) dots++;
            }
        }
        return dots;
    }

    private static int brightness(int rgb) {
        return ((rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255)) / 3;
    }

    /** Finely tessellated: many of its faces are seen from the side, where a rounding error turns them. */
    private static String ball() {
        int around = 96;
        int down = 64;
        StringBuilder obj = new StringBuilder();
        for (int i = 0; i <= down; i++) {
            double a = Math.PI * i / down;
            for (int j = 0; j < around; j++) {
                double b = 2 * Math.PI * j / around;
                obj.append(String.format(
                        Locale.ROOT,
                        "v %.5f %.5f %.5f%n",
                        Math.sin(a) * Math.cos(b),
                        Math.cos(a),
                        Math.sin(a) * Math.sin(b)));
            }
        }
        for (int i = 0; i < down; i++) {
            for (int j = 0; j < around; j++) {
                int a = i * around + j + 1;
                int b = i * around + (j + 1) % around + 1;
                if (i < down - 1) obj.append("f " + a + " " + (b + around) + " " + (a + around) + "\n");
                if (i > 0) obj.append("f " + a + " " + b + " " + (b + around) + "\n");
            }
        }
        return obj.toString();
    }

    private static BufferedImage picture(String dataUrl) throws Exception {
        byte[] png = Base64.getDecoder().decode(dataUrl.substring(dataUrl.indexOf(',') + 1));
        return ImageIO.read(new ByteArrayInputStream(png));
    }
}
