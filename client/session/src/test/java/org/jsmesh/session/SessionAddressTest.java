package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.net.URI;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.zip.GZIPOutputStream;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What addresses a session takes, and what it makes of what lies there. */
class SessionAddressTest extends SessionFixture {
    @Test
    void shouldAskForAnUnknownHostOnce() throws Exception {
        SessionOptions patient = SessionOptions.defaults().withBackoffMillis(600_000);
        for (String file : new String[] {"a.jsm", "manifest.json"}) {
            URI nowhere = URI.create("http://nonexistent.invalid/" + file);
            try (StreamingSession session = open(nowhere, patient)) {
                assertThatThrownBy(() -> session.complete().get(30, TimeUnit.SECONDS))
                        .cause()
                        .isInstanceOf(FetchException.class)
                        .hasMessageContaining(nowhere + ": the host is unknown");
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"http://127.0.0.1:99999/a", "file:relative.jsm", "ftp://127.0.0.1/a"})
    void shouldRefuseAnImpossibleAddressAtOnce(String address) {
        assertThatThrownBy(() -> open(URI.create(address)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(address);
    }

    @Test
    void shouldOpenAManifest() {
        String hash = FakeArchive.sha256(archive);
        server.put("/m/fake/" + hash + ".jsm", archive);
        URI manifest = proxy.through(server.put(
                "/m/fake/manifest.json", manifest(hash + ".jsm", hash, hash).getBytes(), "application/json", null));
        try (StreamingSession session = open(manifest)) {
            session.refine(500).join();
            assertThat(session.complete().join().identical()).isTrue();
        }
        assertThat(proxy.exchanges().get(0).target()).isEqualTo("/m/fake/manifest.json");
        assertTiling(proxy.exchanges().subList(1, proxy.exchanges().size()), archive.length);
    }

    @Test
    void shouldWaitForAManifestThatComesLate() throws Exception {
        String hash = FakeArchive.sha256(archive);
        server.put("/m/fake/" + hash + ".jsm", archive);
        CountDownLatch made = new CountDownLatch(1);
        AtomicInteger asked = new AtomicInteger();
        URI slow = server.handle("/slow.json", exchange -> {
            try (exchange) {
                asked.incrementAndGet();
                Await.open("the test to let the answer go", made);
                byte[] json = manifest("m/fake/" + hash + ".jsm", hash, hash).getBytes();
                exchange.sendResponseHeaders(200, json.length);
                exchange.getResponseBody().write(json);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        });
        try (StreamingSession session = open(slow, QUICK)) {
            CompletableFuture<SessionResult> result = session.complete();
            assertThatThrownBy(() -> result.get(2, TimeUnit.SECONDS)).isInstanceOf(TimeoutException.class);
            session.cancel();
            assertThatThrownBy(result::join).isInstanceOf(CancellationException.class);
            CompletableFuture<SessionResult> again = session.complete();
            Await.until("the second request", () -> asked.get() >= 2);
            made.countDown();
            assertThat(again.join().identical()).isTrue();
            assertThat(asked).hasValue(2);
        }
    }

    @Test
    void shouldKnowAManifestByItsType() {
        String hash = FakeArchive.sha256(archive);
        server.put("/m/fake/" + hash + ".jsm", archive);
        URI manifest = server.put(
                "/m/fake",
                manifest("fake/" + hash + ".jsm", hash, hash).getBytes(),
                "application/json; charset=utf-8",
                null);
        try (StreamingSession session = open(manifest)) {
            assertThat(session.complete().join().identical()).isTrue();
        }
    }

    @Test
    void shouldAskForACompressedManifestAndUnpackIt() throws Exception {
        String hash = FakeArchive.sha256(archive);
        server.put("/m/fake/" + hash + ".jsm", archive);
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(packed)) {
            gzip.write(manifest("fake/" + hash + ".jsm", hash, hash).getBytes());
        }
        try (StreamingSession session = open(compressed("/m/packed.json", packed.toByteArray()))) {
            assertThat(session.complete().join().identical()).isTrue();
        }
    }

    @Test
    void shouldSayThatAManifestIsCompressedBadly() {
        try (StreamingSession session = open(compressed("/m/bad.json", new byte[100]))) {
            assertThatThrownBy(() -> session.complete().join()).hasMessageContaining("compressed badly");
        }
    }

    /** An address that answers only who takes compressed answers. */
    private URI compressed(String path, byte[] bytes) {
        return server.handle(path, exchange -> {
            boolean taken = "gzip".equals(exchange.getRequestHeaders().getFirst("Accept-Encoding"));
            exchange.getResponseHeaders().set("Content-Encoding", "gzip");
            exchange.getResponseHeaders().set("Content-Type", "application/json");
            exchange.sendResponseHeaders(taken ? 200 : 404, taken ? bytes.length : -1);
            if (taken) exchange.getResponseBody().write(bytes);
            exchange.close();
        });
    }

    @Test
    void shouldNotCallAnotherArchiveIdentical() {
        String other = FakeArchive.sha256(new byte[0]);
        URI address = server.put("/m/fake/" + other + ".jsm", archive);
        try (StreamingSession session = open(address)) {
            SessionResult result = session.complete().join();
            assertThat(result.identical()).isFalse();
            assertThat(result.difference()).contains(other);
        }
        String hash = FakeArchive.sha256(archive);
        URI manifest = server.put(
                "/m/fake/manifest.json",
                manifest("/m/fake/" + other + ".jsm", hash, other).getBytes(),
                "application/json",
                null);
        try (StreamingSession session = open(manifest)) {
            SessionResult result = session.complete().join();
            assertThat(result.identical()).isFalse();
            assertThat(result.difference()).contains("manifest").contains(other);
        }
    }

    @Test
    void shouldSayWhatIsWrongWithAnAddress() {
        try (StreamingSession session = open(server.put("/x.jsm", archive).resolve("/missing.jsm"))) {
            assertFailure(session, FetchException.class, "404");
        }
        try (StreamingSession session = open(server.put("/page", "<html>".getBytes(), "text/html", null))) {
            assertFailure(session, FetchException.class, "is a page");
        }
        try (StreamingSession session = open(server.put("/bad.json", "{}".getBytes(), "application/json", null))) {
            assertFailure(session, FetchException.class, "archiveUrl");
        }
        try (StreamingSession session = open(server.put(
                "/evil.json",
                manifest("file:///etc/passwd", "0".repeat(64), "0".repeat(64)).getBytes(),
                "application/json",
                null))) {
            assertFailure(session, FetchException.class, "neither http nor https");
        }
        assertThatThrownBy(() -> open(URI.create("ftp://host/a.jsm")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("ftp://host/a.jsm");
    }

    private static String manifest(String url, String archiveHash, String meshHash) {
        return "{\"archiveUrl\":\"" + url + "\",\"archiveSha256\":\"" + archiveHash + "\",\"meshSha256\":\"" + meshHash
                + "\",\"batches\":[{\"bytes\":3000},{\"bytes\":1024}]}";
    }
}
