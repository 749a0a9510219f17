package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.web.testing.Browser;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A scan in map coordinates on the page: as smooth as at the origin, and proved. */
@Tag("long")
@Timeout(300)
class PageFarScanTest {
    @TempDir
    static Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"wasm", "js"})
    void shouldBeDrawnAsAtTheOrigin(String decoder) throws Exception {
        Path served = Files.createDirectories(folder.resolve(decoder).resolve("served"));
        FarScan.write(served.resolve("far.obj"), 60, 450_000, 5_411_000, 313);
        FarScan.write(served.resolve("near.obj"), 60, -10, -10, 3);
        try (ModelStore store =
                        new ModelStore(StoreSettings.of(served), new ModelFilesEncoder(EncoderSettings.defaults()));
                JsmServer server = JsmServer.start(ServerSettings.defaults(), store);
                Browser browser = new Browser(
                        Files.createDirectory(folder.resolve(decoder).resolve("profile")))) {
            BufferedImage near = picture(browser, server, "near", decoder);
            BufferedImage far = picture(browser, server, "far", decoder);
            PagePictures.keep("far-scan-" + decoder, far);
            PagePictures.assertAgree(far, near, .999, .1);
            assertThat((String) browser.call("return (await fetch('m/index.json')).text();"))
                    .contains("\"bounds\":[450000.0,5411000.0,");
            String fine = (String) browser.call("return document.getElementById('fine').textContent;");
            assertThat(fine.replaceAll("\\D", "")).contains("4500005411000");
        }
    }

    private static BufferedImage picture(Browser browser, JsmServer server, String model, String decoder)
            throws Exception {
        browser.open(server.uri().resolve("?m=" + model + "&decoder=" + decoder));
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        browser.call("await jsm.complete();");
        browser.await("window.jsm.state === 'complete' || window.jsm.state === 'error'");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        // Both pictures are those of the same renderer.
        browser.await("document.getElementById('model').view.isWhole");
        return browser.snapshot(PageFixture.WIDTH, PageFixture.HEIGHT);
    }
}
