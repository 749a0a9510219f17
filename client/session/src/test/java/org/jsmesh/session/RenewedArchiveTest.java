package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Models that change while they are fetched through their manifest. */
class RenewedArchiveTest extends SessionFixture {
    @TempDir
    private Path folder;

    private final byte[] next = FakeArchive.of(2000, 300_000, 7);

    private URI manifestOf(byte[] bytes) {
        String hash = FakeArchive.sha256(bytes);
        server.put("/m/x/" + hash + ".jsm", bytes);
        String json = "{\"archiveUrl\":\"" + hash + ".jsm\",\"archiveSha256\":\"" + hash + "\",\"meshSha256\":\"" + hash
                + "\"}";
        return proxy.through(
                server.put("/m/x/manifest.json", json.getBytes(StandardCharsets.UTF_8), "application/json", null));
    }

    private void replace() {
        manifestOf(next);
        server.remove("/m/x/" + FakeArchive.sha256(archive) + ".jsm");
    }

    @Test
    void shouldSayThatTheManifestNamesAnother() {
        URI manifest = manifestOf(archive);
        proxy.bytesPerSecond(200_000);
        try (StreamingSession session = open(manifest)) {
            session.refine(200).join();
            replace();
            assertFailure(session, ArchiveChangedException.class, "its manifest names another one");
            assertFailure(session, ArchiveChangedException.class, "open it again");
        }
    }

    @Test
    void shouldTakeTheNewOneWhenNothingHasArrived() {
        URI manifest = manifestOf(archive);
        SessionOptions keeping = QUICK.withCache(folder);
        server.remove("/m/x/" + FakeArchive.sha256(archive) + ".jsm");
        proxy.delayMillis(20);
        String hash = FakeArchive.sha256(next);
        try (StreamingSession session =
                StreamingSession.open(manifest, keeping, FakeArchive.decoder(hash), heard, Runnable::run)) {
            var result = session.complete();
            while (proxy.exchanges().isEmpty()) Thread.onSpinWait();
            while (proxy.exchanges().get(0).status() == 0) Thread.onSpinWait();
            manifestOf(next);
            assertThat(result.join().identical()).isTrue();
        }
        assertThat(folder)
                .isDirectoryNotContaining(f -> f.getFileName().toString().endsWith(".jsm")
                        && !f.getFileName().toString().startsWith(hash));
        assertThat(folder).isDirectoryContaining(f -> f.getFileName().toString().startsWith(hash));
    }

    @Test
    void shouldSayThatTheArchiveIsGoneWhenTheManifestStillNamesIt() {
        URI manifest = manifestOf(archive);
        server.remove("/m/x/" + FakeArchive.sha256(archive) + ".jsm");
        try (StreamingSession session = open(manifest)) {
            assertFailure(session, FetchException.class, "404");
        }
    }
}
