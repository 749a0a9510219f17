package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Map;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ManagementServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStores;
import org.jsmesh.objects.Upload;
import org.jsmesh.s3.testing.S3Mock;
import org.jsmesh.store.bucket.SiteSettings;
import org.jsmesh.store.bucket.SiteStore;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** {@code jsm serve} of a site in a bucket. */
@Timeout(120)
class ServeBucketTest {
    @TempDir
    private static Path shared;

    private static Path site;
    private static Path archive;
    private static Path original;
    private static S3Mock mock;
    private static String address;

    @TempDir
    private Path folder;

    private final HttpClient client = HttpClient.newHttpClient();

    @BeforeAll
    static void publish() throws Exception {
        archive = shared.resolve("torus.jsm");
        Cli.ok("encode", Bumpy.write(shared.resolve("torus.ply"), 100), "-o", archive);
        original = shared.resolve("original.ply");
        Cli.ok("decode", archive, "-o", original);
        site = shared.resolve("site");
        Cli.ok("encode", archive, "--site", site);
        mock = S3Mock.shared();
        address = "s3://" + mock.bucket() + "/some/site";
        try (ObjectStore files = new FolderObjectStore(site);
                ObjectStore bucket = ObjectStores.open(address)) {
            files.list("", "", object -> {
                bucket.put(Upload.of(object.key(), ObjectContent.of(site.resolve(object.key()))));
                return true;
            });
        }
    }

    private HttpResponse<byte[]> get(URI url, String... headers) throws IOException, InterruptedException {
        HttpRequest.Builder request = HttpRequest.newBuilder(url);
        if (headers.length > 0) request.headers(headers);
        return client.send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
    }

    /** Streams the model by the command, to the last byte. */
    private void fetch(URI manifest, String... options) throws IOException {
        Path got = folder.resolve("got.ply");
        Files.deleteIfExists(got);
        Object[] args = {"fetch", manifest, "--full", "-o", got};
        Object[] all = Arrays.copyOf(args, args.length + options.length);
        System.arraycopy(options, 0, all, args.length, options.length);
        Cli.ok(all);
        assertThat(Files.readAllBytes(got)).isEqualTo(Files.readAllBytes(original));
    }

    @Test
    void shouldServeWhatIsInTheBucket() throws Exception {
        try (ObjectStore bucket = ObjectStores.open(address);
                SiteStore models = SiteStore.open(bucket, SiteSettings.defaults());
                JsmServer server = JsmServer.start(ServerSettings.defaults(), models);
                ManagementServer management = ManagementServer.start("127.0.0.1", 0, models, server)) {
            URI root = server.uri();
            fetch(root.resolve("m/torus/manifest.json"));
            fetch(root.resolve("m/torus/manifest.json"), "--server-plan");
            String page = new String(get(root.resolve("m/torus/")).body(), StandardCharsets.UTF_8);
            assertThat(page).contains("data:image/jpeg", "\"torus\"");
            HttpResponse<byte[]> catalogue = get(root.resolve("m/index.json"), "Accept-Encoding", "identity");
            assertThat(catalogue.body()).isEqualTo(Files.readAllBytes(site.resolve("m/index.json")));
            assertThat(get(root.resolve("m/vase/manifest.json")).statusCode()).isEqualTo(404);
            URI ready = URI.create("http://127.0.0.1:" + management.port() + "/health/ready");
            assertThat(get(ready).statusCode()).isEqualTo(200);
            String metrics = new String(get(ready.resolve("/metrics")).body(), StandardCharsets.UTF_8);
            assertThat(metrics).contains("jsm_models 1.0", "jsm_store_failed_total 0.0");
        }
    }

    @Test
    void shouldSendClientsToTheBucketForArchives() throws Exception {
        SiteSettings redirecting = SiteSettings.defaults().withRedirect(Duration.ofMinutes(5));
        try (ObjectStore bucket = ObjectStores.open(address);
                SiteStore models = SiteStore.open(bucket, redirecting);
                JsmServer server = JsmServer.start(ServerSettings.defaults(), models)) {
            URI manifest = server.uri().resolve("m/torus/manifest.json");
            fetch(manifest);
            String text = new String(get(manifest).body(), StandardCharsets.UTF_8);
            String name = text.replaceFirst("(?s).*\"archiveUrl\"\\s*:\\s*\"([^\"]+)\".*", "$1");
            HttpResponse<byte[]> sent = get(manifest.resolve(name), "Range", "bytes=100-199");
            assertThat(sent.statusCode()).isEqualTo(307);
            URI there = URI.create(sent.headers().firstValue("Location").orElseThrow());
            assertThat(there.getAuthority()).isEqualTo(mock.endpoint().getAuthority());
            HttpResponse<byte[]> part = get(there, "Range", "bytes=100-199");
            assertThat(part.statusCode()).isEqualTo(206);
            assertThat(part.body()).isEqualTo(Arrays.copyOfRange(Files.readAllBytes(archive), 100, 200));
        }
    }

    @Test
    void shouldSayWhatIsMissing() {
        Cli none = Cli.run("serve", address + "/elsewhere", "--port", "0");
        assertThat(none.code()).isEqualTo(1);
        assertThat(none.err())
                .contains("holds no site", "jsm encode --site " + address)
                .hasLineCount(1);
        Cli bucket = Cli.run("serve", "s3://no-such-bucket-here/x", "--port", "0");
        assertThat(bucket.code()).isEqualTo(1);
        assertThat(bucket.err()).contains("no-such-bucket-here").hasLineCount(1);
        Cli scheme = Cli.run("serve", "gopher://host/x", "--port", "0");
        assertThat(scheme.code()).isEqualTo(1);
        assertThat(scheme.err()).contains("gopher://").hasLineCount(1);
    }

    @Test
    void shouldRefuseOptionsThatMeanNothing() {
        Cli cache = Cli.run("serve", address, "--port", "0", "--cache", folder);
        assertThat(cache.code()).isEqualTo(2);
        assertThat(cache.err()).contains("--cache means nothing for a site", "Leave it out");
        Map<String, String> environment = Map.of("JSM_ENCODERS", "3", "JSM_PORT", "0");
        Cli encoders = Cli.with(environment, "serve", site);
        assertThat(encoders.code()).isEqualTo(2);
        assertThat(encoders.err()).contains("--encoders (JSM_ENCODERS) means nothing");
        Cli redirect = Cli.run("serve", folder, "--port", "0", "--redirect");
        assertThat(redirect.code()).isEqualTo(2);
        assertThat(redirect.err()).contains("--redirect needs a site in a bucket");
        Cli here = Cli.run("serve", site, "--port", "0", "--redirect");
        assertThat(here.code()).isEqualTo(1);
        assertThat(here.err()).contains("has no addresses to send clients to", "without --redirect");
    }
}
