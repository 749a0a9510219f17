package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the page calls the original, and what it says of the rest. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Timeout(300)
class PageClaimsTest {
    @TempDir
    static Path folder;

    private ModelStore store;
    private JsmServer server;
    private Browser browser;

    @BeforeAll
    void start() throws Exception {
        browser = new Browser(Files.createDirectory(folder.resolve("profile")));
        Path served = Files.createDirectory(folder.resolve("served"));
        Path painted = ClaimedModels.archive(ClaimedModels.painted(folder.resolve("a")), served.resolve("painted.jsm"));
        ClaimedModels.altered(painted, served.resolve("altered.jsm"));
        ClaimedModels.archive(ClaimedModels.unpainted(folder.resolve("b")), served.resolve("unpainted.jsm"));
        ClaimedModels.archive(
                ClaimedModels.annotated(folder.resolve("annotated.ply")), served.resolve("annotated.jsm"));
        store = new ModelStore(StoreSettings.of(served), new ModelFilesEncoder(EncoderSettings.defaults()));
        server = JsmServer.start(ServerSettings.defaults(), store);
    }

    @AfterAll
    void stop() throws Exception {
        if (browser != null) browser.close();
        if (server != null) server.close();
        if (store != null) store.close();
    }

    private void complete(String model, String decoder) {
        browser.open(server.uri().resolve("?m=" + model + "&decoder=" + decoder));
        browser.await(
                "window.jsm?.state === 'idle' || window.jsm?.state === 'complete' || window.jsm?.state === 'error'");
        browser.call("await jsm.complete();");
        browser.await("window.jsm.state === 'complete' || window.jsm.state === 'error'");
    }

    @Test
    void shouldCallIdenticalWhatHasAllOfItsFile() {
        complete("painted", "wasm");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(browser.text("#proof")).isEqualTo("identical to the original");
        assertThat((String) browser.call("return document.getElementById('proof').title;"))
                .startsWith("Identical to the original file's geometry, materials and pictures.")
                .contains((String) browser.call("return jsm.modelSha256;"));
        assertThat(browser.isShown("#losses")).isFalse();
        assertThat(browser.consoleErrors()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"wasm", "js"})
    void shouldNameAPictureThatWasAltered(String decoder) {
        complete("altered", decoder);
        assertThat(browser.text("#alert-text")).contains("the picture wood.png is not the one that was encoded");
        assertThat(browser.isShown("#proof")).isFalse();
        assertThat(browser.call("return jsm.proved || jsm.identical;")).isEqualTo(false);
    }

    @Test
    void shouldWarnWhereSomethingThatIsSeenIsMissing() {
        complete("unpainted", "wasm");
        assertThat(browser.call("return jsm.proved && !jsm.identical;")).isEqualTo(true);
        assertThat(browser.text("#proof")).isEqualTo("not the whole original");
        assertThat(browser.isShown("#proof .caution")).isTrue();
        assertThat(browser.isShown("#proof .tick")).isFalse();
        assertThat(browser.text("#losses")).startsWith("⚠ Not the whole original: textures not found: wood.png.");
        assertThat((String) browser.call("return document.getElementById('losses').role;"))
                .isEqualTo("status");
    }

    @Test
    void shouldSayBesideIdenticalWhatOfTheFileIsNotKept() {
        complete("annotated", "wasm");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(browser.text("#losses")).startsWith("Of the file not kept: ").contains("hinge");
    }
}
