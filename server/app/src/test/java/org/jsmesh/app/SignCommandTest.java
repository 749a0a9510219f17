package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.secret.SignKeys;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.web.testing.Browser;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code jsm sign}, and what opens with the addresses that it prints. */
@Timeout(180)
@Tag("slow")
class SignCommandTest {
    @TempDir
    private Path folder;

    private Path keys;
    private ModelStore store;
    private JsmServer server;

    @BeforeEach
    void start() throws Exception {
        keys = Files.writeString(folder.resolve("keys"), "0123456789abcdef0123456789abcdef\n");
        Path models = Files.createDirectory(folder.resolve("models"));
        Cli.ok("encode", Bumpy.write(folder.resolve("bumpy.ply"), 30), "-o", models.resolve("bumpy.jsm"), "--quiet");
        store = new ModelStore(
                StoreSettings.of(models).withCache(folder.resolve("cache")),
                new ModelFilesEncoder(EncoderSettings.defaults()));
        server = JsmServer.start(ServerSettings.defaults().withSignKeys(SignKeys.read(keys)), store);
    }

    @AfterEach
    void stop() {
        server.close();
        store.close();
    }

    private URI sign(String path) {
        return URI.create(Cli.ok(
                        "sign",
                        "--sign-key",
                        keys,
                        "--expires",
                        "10m",
                        server.uri().resolve(path))
                .out()
                .strip());
    }

    @ParameterizedTest
    @ValueSource(strings = {"m/bumpy/manifest.json", "m/"})
    void shouldFetchThroughASignedAddress(String signed) throws Exception {
        String query = sign(signed).getRawQuery();
        Path out = folder.resolve("out.ply");
        URI manifest = server.uri().resolve("m/bumpy/manifest.json?" + query);
        Cli.ok("fetch", manifest, "-o", out, "--full");
        assertThat(out).isNotEmptyFile();
        Files.delete(out);
        Cli.ok("fetch", manifest, "-o", out, "--full", "--server-plan");
        assertThat(out).isNotEmptyFile();
        Cli refused = Cli.run("fetch", server.uri().resolve("m/bumpy/manifest.json"), "-o", folder.resolve("no.ply"));
        assertThat(refused.code()).isEqualTo(1);
        assertThat(refused.err()).contains("403");
    }

    @Test
    void shouldOpenThePage() throws Exception {
        try (Browser browser = Browser.drawingCoarsely(Files.createDirectory(folder.resolve("profile")))) {
            browser.open(sign("m/bumpy/"));
            browser.await("window.jsm?.header && jsm.bytes > 0 || window.jsm?.state === 'error'");
            assertThat((String) browser.call("return jsm.state;")).isNotEqualTo("error");
            browser.call("document.getElementById('original').click();");
            browser.await("jsm.bytes === jsm.header.archiveBytes || jsm.state === 'error'");
            assertThat((String) browser.call("return jsm.state;")).isNotEqualTo("error");
        }
    }

    @Test
    void shouldListModelsAndLeadToThem() throws Exception {
        try (Browser browser = Browser.drawingCoarsely(Files.createDirectory(folder.resolve("profile")))) {
            browser.open(sign("m/"));
            browser.await("document.querySelector('a.card') !== null");
            browser.call("document.querySelector('a.card').click();");
            browser.await("window.jsm?.header && jsm.bytes > 0 || window.jsm?.state === 'error'");
            assertThat((String) browser.call("return jsm.state;")).isNotEqualTo("error");
        }
    }

    @ParameterizedTest
    @CsvSource({
        "https://h/m/chair/, chair",
        "https://h/m/chair/?old=query, chair",
        "https://h/deep/m/chair/manifest.json, chair",
        "https://h/models/%E6%A4%85-obj-abcdef/annotations.json, 椅-obj-abcdef",
        "https://h/m/, ''",
        "https://h/models/index.json, ''"
    })
    void shouldSignTheModelOfAnAddress(String address, String id) throws Exception {
        URI signed =
                URI.create(Cli.ok("sign", "--sign-key", keys, address).out().strip());
        assertThat(signed.toString()).startsWith(address.replaceFirst("\\?.*", "") + "?expires=");
        assertThat(SignKeys.read(keys).verify(id, signed.getRawQuery(), java.time.Instant.now()))
                .isEqualTo(SignKeys.Verdict.GOOD);
        assertThat(SignKeys.read(keys).verify("other", signed.getRawQuery(), java.time.Instant.now()))
                .isEqualTo(id.isEmpty() ? SignKeys.Verdict.GOOD : SignKeys.Verdict.WRONG);
    }

    @ParameterizedTest
    @CsvSource({
        "https://h/m/chair, 1h, no address of a model",
        "https://h/m/chair/, soon, no time",
        "https://h/m/chair/, 0s, no time"
    })
    void shouldSayWhatItCannotSign(String address, String expires, String words) {
        Cli cli = Cli.run("sign", "--sign-key", keys, "--expires", expires, address);
        assertThat(cli.code()).isEqualTo(2);
        assertThat(cli.err()).contains(words).hasLineCount(1);
    }

    @Test
    void shouldSayWhatIsWrongWithTheKeys() throws Exception {
        Files.writeString(keys, "short");
        for (Cli cli : new Cli[] {
            Cli.run("sign", "--sign-key", keys, "https://h/m/chair/"),
            Cli.run("serve", folder.resolve("models"), "--port", "0", "--sign-key", keys)
        }) {
            assertThat(cli.code()).isEqualTo(1);
            assertThat(cli.err())
                    .contains("keys", "openssl rand")
                    .doesNotContain("short\n")
                    .hasLineCount(1);
        }
    }
}
