package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStores;
import org.jsmesh.s3.testing.S3Mock;
import org.jsmesh.session.testing.ProxiedExchange;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.store.bucket.SiteSettings;
import org.jsmesh.store.bucket.SiteStore;
import org.jsmesh.web.testing.Browser;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The page where archives come from a bucket, which is another origin. */
@Timeout(300)
class PageRedirectTest {
    @TempDir
    private Path folder;

    @Test
    void shouldReadArchivesWhereTheServerSendsIt() throws Exception {
        S3Mock mock = S3Mock.shared();
        Path model = GrainyTorus.write(folder.resolve("torus.ply"), 280, 78);
        String site = "s3://" + mock.bucket() + "/site";
        Cli.ok("encode", model, "--site", site);
        try (ShapingProxy bucket = ShapingProxy.to(mock.endpoint())) {
            System.setProperty("aws.endpointUrlS3", "http://127.0.0.1:" + bucket.port());
            try (ObjectStore objects = ObjectStores.open(site);
                    SiteStore models =
                            SiteStore.open(objects, SiteSettings.defaults().withRedirect(Duration.ofMinutes(5)));
                    JsmServer server = JsmServer.start(ServerSettings.defaults(), models);
                    Browser browser = Browser.drawingCoarsely(Files.createDirectory(folder.resolve("profile")))) {
                browser.open(server.uri().resolve("m/torus/"));
                browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
                browser.call("await jsm.complete();");
                browser.await("jsm.state === 'complete' && document.getElementById('model').view.isWhole");
                assertThat(browser.isShown("#alert")).isFalse();
                assertThat(browser.consoleErrors()).isEmpty();
                List<ProxiedExchange> redirected = bucket.exchanges().stream()
                        .filter(e -> e.target().contains("X-Amz-Signature="))
                        .toList();
                assertThat(redirected)
                        .isNotEmpty()
                        .allMatch(e -> e.status() == 206 && e.target().contains(".jsm"));
                // With what came from the server, every byte once.
                Number bytes = (Number) browser.call("return jsm.bytes;");
                long first = redirected.stream()
                        .mapToLong(ProxiedExchange::fromByte)
                        .min()
                        .orElseThrow();
                assertThat(first
                                + redirected.stream()
                                        .mapToLong(ProxiedExchange::bodyBytes)
                                        .sum())
                        .isEqualTo(bytes.longValue());
            } finally {
                S3Mock.shared();
            }
        }
    }
}
