package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Models that change while they are fetched through their manifest. */
class RenewedArchiveTest extends SessionFixture {
    @TempDir
    private Path folder;

    private int renewals;
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

    /** Opens sessions in turn, each with the decoder of what the server has then. */
    private RenewingSession renewing(URI address, byte[]... archives) {
        List<byte[]> turns = new ArrayList<>(List.of(archives));
        return new RenewingSession(
                () -> {
                    String hash = FakeArchive.sha256(turns.size() > 1 ? turns.remove(0) : turns.get(0));
                    return StreamingSession.open(address, QUICK, FakeArchive.decoder(hash), heard, Runnable::run);
                },
                () -> renewals++,
                Runnable::run);
    }

    @Test
    void shouldBeginAgainWithTheNewOne() {
        URI manifest = manifestOf(archive);
        proxy.bytesPerSecond(200_000);
        try (RenewingSession session = renewing(manifest, archive, next)) {
            StreamingSession first = session.session();
            session.call(s -> s.refine(200)).join();
            replace();
            proxy.bytesPerSecond(1e9);
            SessionResult result = session.call(StreamingSession::complete).join();
            assertThat(result.identical()).isTrue();
            assertThat(result.archiveSha256()).isEqualTo(FakeArchive.sha256(next));
            assertThat(session.session()).isNotSameAs(first);
        }
        assertThat(renewals).isEqualTo(1);
    }

    @Test
    void shouldLetAllCallsGoOnWithTheNewOne() {
        URI manifest = manifestOf(archive);
        proxy.bytesPerSecond(200_000);
        try (RenewingSession session = renewing(manifest, archive, next)) {
            session.call(s -> s.refine(200)).join();
            replace();
            proxy.bytesPerSecond(1e9);
            var both = List.of(session.call(StreamingSession::complete), session.call(StreamingSession::complete));
            for (var call : both) assertThat(call.join().identical()).isTrue();
        }
        assertThat(renewals).isEqualTo(1);
    }

    @Test
    void shouldNotBeginAgainForEver() {
        URI manifest = manifestOf(archive);
        proxy.bytesPerSecond(200_000);
        try (RenewingSession session = renewing(manifest, archive)) {
            assertThatThrownBy(() -> session.call(s -> s.refine(200)
                                    .thenCompose(round -> {
                                        replace();
                                        return s.complete();
                                    })
                                    .whenComplete((result, error) -> manifestOf(archive)))
                            .join())
                    .hasCauseInstanceOf(ArchiveChangedException.class);
        }
        assertThat(renewals).isEqualTo(3);
    }

    @Test
    void shouldTakeTheNewOneWhenNothingHasArrived() throws Exception {
        URI manifest = manifestOf(archive);
        SessionOptions keeping = QUICK.withCache(folder);
        server.remove("/m/x/" + FakeArchive.sha256(archive) + ".jsm");
        proxy.delayMillis(20);
        String hash = FakeArchive.sha256(next);
        try (StreamingSession session =
                StreamingSession.open(manifest, keeping, FakeArchive.decoder(hash), heard, Runnable::run)) {
            var result = session.complete();
            Await.until("the first request", () -> !proxy.exchanges().isEmpty());
            Await.until("its answer", () -> proxy.exchanges().get(0).status() != 0);
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
