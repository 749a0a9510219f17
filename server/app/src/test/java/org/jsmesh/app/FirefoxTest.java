package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.test.SampleModels;
import org.jsmesh.web.testing.Firefox;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The page in a real Firefox: what it does in Chromium is for other tests. */
@Timeout(300)
class FirefoxTest {
    @TempDir
    private Path folder;

    @Test
    void shouldShowAModelWithEitherDecoder() throws Exception {
        Path models = Files.createDirectory(folder.resolve("models"));
        Files.copy(SampleModels.project().resolve("models/octopus.ply"), models.resolve("octopus.ply"));
        try (Firefox firefox = new Firefox(Files.createDirectory(folder.resolve("profile")));
                ModelStore store = new ModelStore(
                        StoreSettings.of(models).withCache(folder.resolve("cache")),
                        new ModelFilesEncoder(EncoderSettings.defaults()));
                JsmServer server = JsmServer.start(ServerSettings.defaults(), store)) {
            for (String decoder : new String[] {"wasm", "js"}) {
                String query = decoder.equals("js") ? "?decoder=js" : "";
                firefox.open(server.uri().resolve("m/octopus/" + query));
                firefox.await("window.jsm && jsm.state !== 'loading' && jsm.state !== 'refining'");
                JsonNode shown = firefox.call("await jsm.complete();"
                        + "return [jsm.state, jsm.error, jsm.identical, jsm.decoder, jsm.faces];");
                assertThat(shown).hasToString("[\"complete\",null,true,\"" + decoder + "\",84056]");
                firefox.await("document.getElementById('model').view.isWhole");
                assertThatItIsTheOctopus(firefox.snapshot(480, 360));
            }
        }
    }

    /** Orange, and in the middle of nothing. */
    private static void assertThatItIsTheOctopus(BufferedImage picture) {
        long[] sums = new long[4];
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                int argb = picture.getRGB(x, y);
                if (argb >>> 24 < 255) continue;
                sums[3]++;
                for (int c = 0; c < 3; c++) sums[c] += argb >> 8 * c & 255;
            }
        }
        int pixels = picture.getWidth() * picture.getHeight();
        assertThat(sums[3]).isBetween(pixels / 20L, pixels / 3L);
        assertThat(sums[2]).as("red").isGreaterThan(sums[1] * 3 / 2);
        assertThat(sums[1]).as("green").isGreaterThan(sums[0] * 5 / 4);
        assertThat(picture.getRGB(2, 2) >>> 24).isZero();
    }
}
