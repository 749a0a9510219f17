package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.jsmesh.servlet.ContractServer.JSON;
import static org.jsmesh.servlet.ContractServer.assertError;
import static org.jsmesh.servlet.ContractServer.header;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.secret.SignKeys;
import org.jsmesh.servlet.http.Digests;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.Archive;
import org.jsmesh.store.bucket.FaultyStore;
import org.jsmesh.store.bucket.SiteSettings;
import org.jsmesh.store.bucket.SiteStore;
import org.jsmesh.store.bucket.TestSites;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** How every container serves a site that lies in a store of objects. */
@Timeout(120)
abstract class SiteContract {
    private static final long READ_MILLIS = 30_000;

    @TempDir
    private Path folder;

    @TempDir
    private Path scratch;

    private final HttpClient client =
            HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
    private final List<AutoCloseable> opened = new ArrayList<>();
    private FaultyStore objects;
    private TestServer server;
    private byte[] archive;
    private String sha256;

    abstract TestServer start(SiteStore site, ServletSettings settings) throws Exception;

    @BeforeEach
    void publish() throws Exception {
        archive = TestSites.archive(scratch);
        sha256 = TestSites.publish(folder, "chair", archive);
        TestSites.list(folder, "chair");
        objects = new FaultyStore(new FolderObjectStore(folder));
        opened.add(objects);
    }

    private void serve(SiteSettings settings, ServletSettings servlet, long readMillis) throws Exception {
        SiteStore site = TestSites.open(objects, settings, readMillis);
        opened.add(site);
        server = start(site, servlet);
        opened.add(server::stop);
    }

    private void serve() throws Exception {
        serve(SiteSettings.defaults(), ServletSettings.defaults(), READ_MILLIS);
    }

    @AfterEach
    void stop() throws Exception {
        objects.release();
        for (int i = opened.size() - 1; i >= 0; i--) opened.get(i).close();
    }

    private HttpRequest request(String path, String... headers) {
        HttpRequest.Builder request = HttpRequest.newBuilder(server.root().resolve(path));
        return (headers.length == 0 ? request : request.headers(headers)).build();
    }

    private HttpResponse<byte[]> get(String path, String... headers) throws IOException, InterruptedException {
        return client.send(request(path, headers), HttpResponse.BodyHandlers.ofByteArray());
    }

    private String url() {
        return "m/chair/" + sha256 + ".jsm";
    }

    @Test
    void shouldServeWhatAFolderOfArchivesServes() throws Exception {
        serve();
        JsonNode catalogue = JSON.readTree(get("m/index.json").body());
        assertThat(catalogue.at("/models/0/id").asText()).isEqualTo("chair");
        HttpResponse<byte[]> manifest = get("m/chair/manifest.json");
        assertThat(manifest.body()).isEqualTo(Files.readAllBytes(folder.resolve("m/chair/manifest.json")));
        HttpResponse<byte[]> whole = get(url());
        assertThat(whole.statusCode()).isEqualTo(200);
        assertThat(whole.body()).isEqualTo(archive);
        assertThat(header(whole, "ETag")).isEqualTo('"' + sha256 + '"');
        assertThat(header(whole, "Cache-Control")).contains("immutable");
        HttpResponse<byte[]> part = get(url(), "Range", "bytes=4095-20000", "If-Range", '"' + sha256 + '"');
        assertThat(part.statusCode()).isEqualTo(206);
        assertThat(part.body()).isEqualTo(Arrays.copyOfRange(archive, 4095, 20001));
        assertThat(get(url(), "If-None-Match", '"' + sha256 + '"').statusCode()).isEqualTo(304);
        try (Archive read = Archive.open(folder.resolve("m/chair/" + sha256 + ".jsm"))) {
            BatchIndex index = read.batches();
            int last = index.size() - 1;
            assertThat(get("m/chair/" + sha256 + "/batches/1-" + last).body())
                    .isEqualTo(Arrays.copyOfRange(archive, (int) index.offset(1), archive.length));
            assertThat(get("m/chair/" + sha256 + "/first.jsm").body())
                    .isEqualTo(Arrays.copyOf(archive, index.firstBytes()));
            HttpResponse<byte[]> poster = get("m/chair/" + sha256 + "/poster.jpg");
            assertThat(header(poster, "Content-Type")).isEqualTo("image/jpeg");
            assertThat(poster.body()).hasSize(BatchIndex.payloadBytes(index.bytes(index.poster())));
            String wish = "/patches?from=1&bytesPerSecond=1000&waitMillis=5000";
            assertThat(get("m/chair/" + sha256 + wish).statusCode()).isEqualTo(200);
        }
        String page = new String(get("m/chair/").body(), StandardCharsets.UTF_8);
        assertThat(page).contains(sha256, "The chair");
        assertThat(objects.lists).as("nothing is walked").hasValue(0);
    }

    @Test
    void shouldSayWhatIsNotThere() throws Exception {
        serve();
        for (String path : List.of(
                "m/table/manifest.json", "m/table/", "m/after-x.json", "m/table/annotations.json", "m/chair/status")) {
            HttpResponse<byte[]> answer = get(path);
            assertThat(answer.statusCode()).as(path).isEqualTo(404);
            assertError(answer);
        }
        HttpResponse<byte[]> other = get("m/chair/" + "a".repeat(64) + ".jsm");
        assertThat(other.statusCode()).isEqualTo(404);
        assertThat(assertError(other).get("error").asText()).contains("another one by now", sha256);
        Path away = Files.createDirectory(folder.resolve("m/chair/away"));
        Files.move(folder.resolve("m/index.json"), away.resolve("index.json"));
        assertThatThrownBy(() -> TestSites.open(objects, SiteSettings.defaults(), READ_MILLIS))
                .hasMessageContaining("holds no site")
                .hasMessageContaining("jsm encode --site s3://faulty/site");
    }

    @Test
    void shouldReadWhatItHasReadNoSecondTime() throws Exception {
        serve();
        get(url());
        int reads = objects.reads.get();
        int finds = objects.finds.get();
        assertThat(get(url()).body()).isEqualTo(archive);
        assertThat(get("m/chair/" + sha256 + "/first.jsm").statusCode()).isEqualTo(200);
        assertThat(objects.reads).hasValue(reads);
        assertThat(objects.finds).hasValue(finds);
    }

    @Test
    void shouldShowAModelThatIsPublishedAnewAndStillSendTheOldArchive() throws Exception {
        serve();
        assertThat(get("m/index.json").body()).isNotEmpty();
        String tag = header(get("m/index.json", "Accept-Encoding", "identity"), "ETag");
        assertThat(get("m/index.json", "If-None-Match", tag, "Accept-Encoding", "identity")
                        .statusCode())
                .isEqualTo(304);
        TestSites.publish(folder, "table", archive);
        TestSites.list(folder, "chair", "table");
        Await.until(
                "the new catalogue",
                () -> JSON.readTree(get("m/index.json").body()).get("total").asInt() == 2);
        assertThat(get("m/table/" + sha256 + ".jsm").body()).isEqualTo(archive);
        assertThat(get(url()).body()).isEqualTo(archive);
    }

    @Test
    void shouldTellOfAStoreThatFailsAndGoOnWhenItWorks() throws Exception {
        serve();
        objects.fail(new IOException("the service is failing"));
        for (String path : List.of("m/index.json", "m/chair/manifest.json", url())) {
            HttpResponse<byte[]> answer = get(path, "Origin", "https://elsewhere.example");
            assertThat(answer.statusCode()).as(path).isEqualTo(503);
            assertThat(header(answer, "Retry-After")).isNotBlank();
            assertThat(answer.headers().firstValue("Access-Control-Allow-Origin"))
                    .isPresent();
            assertThat(assertError(answer).get("error").asText()).contains("cannot be read");
        }
        objects.fail(null);
        Await.until("the archive", () -> get(url()).statusCode() == 200);
        assertThat(get(url()).body()).isEqualTo(archive);
    }

    /** More requests than the server has threads wait for a store that does not answer. */
    @Test
    void shouldHoldNoThreadWhileTheStoreHangs() throws Exception {
        serve();
        assertThat(get("m/chair/" + sha256 + "/first.jsm").statusCode()).isEqualTo(200);
        objects.hang();
        List<CompletableFuture<HttpResponse<byte[]>>> answers = new ArrayList<>();
        for (int i = 0; i < 3 * TestServer.THREADS; i++)
            answers.add(client.sendAsync(
                    request("m/other-" + i + "/manifest.json"), HttpResponse.BodyHandlers.ofByteArray()));
        assertThat(get("m/chair/" + sha256 + "/first.jsm").statusCode())
                .as("what is in memory is sent meanwhile")
                .isEqualTo(200);
        for (CompletableFuture<HttpResponse<byte[]>> answer : answers) {
            HttpResponse<byte[]> told = answer.get(60, TimeUnit.SECONDS);
            assertThat(told.statusCode()).isEqualTo(202);
            assertThat(header(told, "Retry-After")).isEqualTo("1");
        }
        objects.release();
        Await.until(
                "the model not to be there",
                () -> get("m/other-1/manifest.json").statusCode() == 404);
    }

    @Test
    void shouldGiveUpAReadThatTakesTooLong() throws Exception {
        serve(SiteSettings.defaults(), ServletSettings.defaults(), 300);
        objects.hang();
        HttpResponse<byte[]> answer = get("m/chair/manifest.json");
        assertThat(answer.statusCode()).isEqualTo(503);
        assertThat(assertError(answer).get("error").asText()).contains("did not answer within 300 ms");
    }

    /** Often, as either the container finds that bytes are missing, or who waited for them. */
    @RepeatedTest(5)
    @Timeout(30)
    void shouldCutAnAnswerWhoseBytesDoNotComeAndGoOnWhereItWasCut() throws Exception {
        serve(SiteSettings.defaults().withMemory(1 << 20), ServletSettings.defaults(), READ_MILLIS);
        assertThat(get("m/chair/" + sha256 + "/first.jsm").statusCode()).isEqualTo(200);
        objects.failAfter(0);
        HttpResponse<byte[]> none = get(url(), "Range", "bytes=" + (archive.length - 100) + "-");
        assertThat(none.statusCode()).isEqualTo(503);
        assertThat(none.headers().firstValue("Content-Range")).isEmpty();
        assertError(none);
        objects.failAfter(2);
        assertThatThrownBy(() -> get(url())).isInstanceOf(IOException.class);
        objects.failAfter(1 << 20);
        assertThat(get(url(), "Range", "bytes=5000-").body())
                .isEqualTo(Arrays.copyOfRange(archive, 5000, archive.length));
    }

    @Test
    void shouldNeverSendBytesOfAnotherVersion() throws Exception {
        serve();
        assertThat(get("m/chair/" + sha256 + "/first.jsm").statusCode()).isEqualTo(200);
        byte[] other = archive.clone();
        other[other.length - 1] ^= 1;
        Path file = folder.resolve("m/chair/" + sha256 + ".jsm");
        Path beside = Files.write(folder.resolve("m/chair/other"), other);
        Files.delete(file);
        Files.move(beside, file);
        HttpResponse<byte[]> answer = get(url(), "Range", "bytes=" + (archive.length - 10) + "-");
        assertThat(answer.statusCode()).isEqualTo(503);
        assertError(answer);
    }

    @Test
    void shouldSendClientsToTheStoreOnlyWithAGoodSignature() throws Exception {
        Path file = Files.writeString(scratch.resolve("keys"), "k".repeat(40));
        SignKeys keys = SignKeys.read(file);
        SiteSettings redirecting = SiteSettings.defaults().withRedirect(Duration.ofSeconds(90));
        serve(redirecting, ServletSettings.defaults().withSignKeys(keys), READ_MILLIS);
        HttpResponse<byte[]> refused = get(url(), "Range", "bytes=0-9");
        assertThat(refused.statusCode()).isEqualTo(403);
        assertThat(refused.headers().firstValue("Location")).isEmpty();
        String signed = url() + '?' + keys.query("chair", Instant.now().plusSeconds(60));
        HttpResponse<byte[]> sent = get(signed, "Range", "bytes=0-9");
        assertThat(sent.statusCode()).isEqualTo(307);
        assertThat(header(sent, "Location"))
                .isEqualTo("https://bucket.example/site/m/chair/" + sha256 + ".jsm?lifetime=90");
        assertThat(header(sent, "Cache-Control")).isEqualTo("no-store");
        assertThat(sent.headers().firstValue("Access-Control-Allow-Origin")).isPresent();
        HttpResponse<byte[]> head = client.send(
                HttpRequest.newBuilder(server.root().resolve(signed))
                        .method("HEAD", HttpRequest.BodyPublishers.noBody())
                        .build(),
                HttpResponse.BodyHandlers.ofByteArray());
        assertThat(head.statusCode()).isEqualTo(200);
        assertThat(header(head, "Content-Length")).isEqualTo(Integer.toString(archive.length));
        String first = signed.replace(".jsm?", "/first.jsm?");
        assertThat(get(first).statusCode()).isEqualTo(200);
        assertThat(Digests.sha256(archive)).isEqualTo(sha256);
    }
}
