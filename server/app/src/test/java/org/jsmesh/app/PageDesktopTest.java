package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.servlet.ViewerJar;
import org.jsmesh.servlet.testing.SignedJars;
import org.junit.jupiter.api.Test;

/** The page offers the desktop viewer where the server has it, and says what each way needs. */
class PageDesktopTest extends PageFixture {
    private static final String BUTTON = ".tools [aria-label='Open in the desktop viewer']";

    private Path jar;

    @Override
    ServerSettings settings() throws Exception {
        jar = SignedJars.viewer(folder.resolve("jsm-viewer.jar"), 1000);
        return super.settings().withViewer(ViewerJar.open(jar));
    }

    @Test
    void shouldOfferWhatFitsTheVisitor() throws Exception {
        open("m=torus");
        browser.await("/idle|complete/.test(window.jsm?.state) && document.querySelector('.tools')");
        String loaded = "return performance.getEntriesByType('resource').some(r => r.name.includes('/desktop'));";
        assertThat(browser.call(loaded)).isEqualTo(false);
        browser.click(BUTTON);
        browser.await("document.querySelectorAll('.ways section').length === 3");
        String address = proxy.through(URI.create("http://127.0.0.1/m/torus/manifest.json"))
                .toString();
        assertThat(browser.text(".tool"))
                .contains("Java 17 or newer", "icedtea-netx", "--register", "jsm-viewer.jar")
                .contains("java -jar jsm-viewer.jar '" + address + "'");

        HttpResponse<byte[]> launch = get(href(0));
        assertThat(launch.headers().firstValue("Content-Type")).contains("application/x-java-jnlp-file");
        assertThat(new String(launch.body(), StandardCharsets.UTF_8)).contains("<argument>" + address + "</argument>");
        assertThat(href(1)).isEqualTo("jsm:" + address);
        assertThat(get(href(2)).body()).isEqualTo(Files.readAllBytes(jar));
        assertThat(browser.text(".ways pre")).contains("curl -fLO '" + href(2) + "'");

        browser.click(".ways button");
        browser.await("document.querySelector('.said').textContent === 'Lines copied'");
        PagePictures.keep("desktop-tool", browser.screenshot());
        assertThat(browser.consoleErrors()).isEmpty();

        // Without the viewer, two ways are left.
        Files.delete(jar);
        browser.click(BUTTON);
        browser.click(BUTTON);
        browser.await("document.querySelectorAll('.ways section').length === 2");
        assertThat(browser.text(".tool"))
                .contains("which this server does not have")
                .doesNotContain("curl");
        assertThat(href(0)).isEqualTo("jsm:" + address);
        // The browser tells that it was answered 404.
        assertThat(browser.consoleErrors()).hasSize(1);
    }

    private String href(int link) {
        return text("document.querySelectorAll('.ways a')[" + link + "].href");
    }

    private static HttpResponse<byte[]> get(String address) throws Exception {
        return HttpClient.newHttpClient()
                .send(HttpRequest.newBuilder(URI.create(address)).build(), HttpResponse.BodyHandlers.ofByteArray());
    }
}
