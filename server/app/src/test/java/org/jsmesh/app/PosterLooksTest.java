package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.assertj.core.api.SoftAssertions;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.poster.Poster;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.studio.Ground;
import org.jsmesh.test.material.MaterialModel;
import org.jsmesh.test.material.MaterialModels;
import org.jsmesh.test.material.MtlModels;
import org.jsmesh.test.picture.PictureComparison;
import org.jsmesh.web.testing.Browser;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The poster of each material beside what the page draws of an archive without poster: its gallery has the same view.
 * Over the pixels that the page draws, the mean difference is below {@value #TOLERANCE} of white.
 */
@Tag("long")
@Timeout(600)
class PosterLooksTest {
    private static final double TOLERANCE = .02;
    /** As in {@link PageLooksTest}, but every fifth model. */
    private static final int STEP = "all".equals(System.getProperty("jsm.test.looks")) ? 1 : 5;

    /** The gallery draws no more of an archive. */
    private static final int SHOWN_BYTES = 24_576;

    private static final String PNG = """
            const canvas = Object.assign(document.createElement('canvas'), { width: 480, height: 360 });
            const context = canvas.getContext('2d');
            context.imageSmoothingQuality = 'high';
            context.drawImage([...document.querySelectorAll('.card')].find((card) =>
                card.querySelector('strong').textContent === args[0]).querySelector('img'), 0, 0, 480, 360);
            return canvas.toDataURL('image/png');
            """;

    @TempDir
    private Path folder;

    @Test
    void shouldShowEachMaterialAsThePageDoes() throws Exception {
        Map<String, BufferedImage> posters = encode();
        assertThat(posters).hasSizeGreaterThan(6);
        StoreSettings settings = StoreSettings.of(folder.resolve("archives")).withCache(folder.resolve("cache"));
        SoftAssertions softly = new SoftAssertions();
        try (ModelStore store = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
                JsmServer server = JsmServer.start(ServerSettings.defaults(), store);
                Browser browser = new Browser(Files.createDirectory(folder.resolve("profile")))) {
            browser.open(server.uri());
            browser.await("document.querySelectorAll('.card').length === " + posters.size());
            for (String name : posters.keySet()) {
                browser.call(
                        "[...document.querySelectorAll('.card')].find((card) => card.querySelector('strong').textContent === args[0]).scrollIntoView();",
                        name);
                browser.await(
                        "![...document.querySelectorAll('.card')].find((card) => card.querySelector('strong').textContent === '"
                                + name + "').querySelector('img').classList.contains('empty')");
                compare(name, picture((String) browser.call(PNG, name)), posters.get(name), softly);
            }
            assertThat(browser.consoleErrors()).isEmpty();
        }
        softly.assertAll();
    }

    private static void compare(String name, BufferedImage drawn, BufferedImage poster, SoftAssertions softly)
            throws IOException {
        BitSet mask = PictureComparison.opaque(drawn);
        BufferedImage expected = onTheGround(drawn);
        PagePictures.keep("poster-" + name, PagePictures.beside(poster, expected));
        softly.assertThat(mask.cardinality()).as(name + ": pixels drawn").isGreaterThan(5000);
        softly.assertThat(PictureComparison.meanDifference(poster, expected, mask))
                .as(name + ": difference from the page")
                .isLessThan(255 * TOLERANCE);
        BitSet ground = new BitSet();
        ground.set(0, 480 * 20);
        softly.assertThat(PictureComparison.meanDifference(poster, expected, ground))
                .as(name + ": difference of the ground")
                .isLessThan(2);
    }

    /** Posters by the names of the models, whose archives without them are put into the folder to serve. */
    private Map<String, BufferedImage> encode() throws IOException {
        Path models = Files.createDirectory(folder.resolve("models"));
        Path archives = Files.createDirectory(folder.resolve("archives"));
        List<MaterialModel> all = Stream.of(MaterialModels.all(), MtlModels.all())
                .flatMap(List::stream)
                .toList();
        for (int i = 0; i < all.size(); i += STEP) all.get(i).write(models);
        Map<String, BufferedImage> posters = new TreeMap<>();
        EncoderSettings settings = EncoderSettings.defaults();
        try (Stream<Path> files = Files.list(models)) {
            for (Path file :
                    files.filter(f -> f.toString().matches(".*\\.(glb|obj)")).toList()) {
                String name = file.getFileName().toString().replaceFirst("\\.[a-z]+$", "");
                byte[] plain = new ModelEncoding(settings.withPoster(false))
                        .encode(file, ProgressListener.NONE)
                        .bytes();
                if (plain.length > SHOWN_BYTES) continue;
                Files.write(archives.resolve(name + ".jsm"), plain);
                byte[] shown = new ModelEncoding(settings)
                        .encode(file, ProgressListener.NONE)
                        .bytes();
                posters.put(
                        name,
                        ImageIO.read(
                                new ByteArrayInputStream(ArchiveFile.of(shown).poster())));
            }
        }
        return posters;
    }

    private static BufferedImage onTheGround(BufferedImage drawn) {
        BufferedImage picture = new BufferedImage(Poster.WIDTH, Poster.HEIGHT, BufferedImage.TYPE_INT_ARGB);
        for (int i = 0; i < Poster.WIDTH * Poster.HEIGHT; i++) {
            int x = i % Poster.WIDTH;
            int y = i / Poster.WIDTH;
            int argb = drawn.getRGB(x, y);
            double[] ground = Ground.colour((x + .5) / Poster.WIDTH, (y + .5) / Poster.HEIGHT);
            int mixed = 255;
            for (int k = 0; k < 3; k++) {
                double c = (argb >> 16 - 8 * k & 255) - ground[k];
                mixed = mixed << 8 | (int) (ground[k] + (argb >>> 24) / 255. * c + .5);
            }
            picture.setRGB(x, y, mixed);
        }
        return picture;
    }

    private static BufferedImage picture(String dataUrl) throws IOException {
        byte[] png = Base64.getDecoder().decode(dataUrl.substring(dataUrl.indexOf(',') + 1));
        return ImageIO.read(new ByteArrayInputStream(png));
    }
}
