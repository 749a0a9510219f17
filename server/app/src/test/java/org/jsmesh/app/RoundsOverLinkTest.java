package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.net.ssl.SSLContext;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.app.server.ShortRecords;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.session.RequestReport;
import org.jsmesh.session.RoundReport;
import org.jsmesh.session.SessionListener;
import org.jsmesh.session.SessionOptions;
import org.jsmesh.session.SessionResult;
import org.jsmesh.session.StreamingSession;
import org.jsmesh.session.link.ShapingPipe;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Rounds over a slow link with encryption, in both versions of HTTP. Nothing timed is asked for: a round is held
 * against what the link carried meanwhile.
 */
@Timeout(120)
@Tag("slow")
class RoundsOverLinkTest {
    private static final Pattern RANGE = Pattern.compile("bytes=(\\d+)-(\\d+)");
    private static final int ROUNDS = 5;
    private static final int RECORD_HEAD_BYTES = 5;
    private static final byte DATA_RECORD = 23;

    @TempDir
    private static Path folder;

    private static SSLContext before;
    private static ModelStore store;
    private static JsmServer server;
    private static URI manifest;

    @BeforeAll
    static void serve() throws Exception {
        Path models = Files.createDirectories(folder.resolve("models"));
        Cli.ok("encode", GrainyTorus.write(folder.resolve("torus.ply"), 300, 110), "-o", models.resolve("torus.jsm"));
        StoreSettings settings = StoreSettings.of(models).withCache(folder.resolve("cache"));
        store = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
        TestKeystore keystore = TestKeystore.in(folder);
        server = JsmServer.start(ServerSettings.defaults().withKeystore(keystore.file(), keystore.password()), store);
        manifest = server.uri().resolve("m/torus/manifest.json");
        before = SSLContext.getDefault();
        SSLContext.setDefault(keystore.trusting());
    }

    @AfterAll
    static void stop() {
        SSLContext.setDefault(before);
        server.close();
        store.close();
    }

    @ParameterizedTest
    @CsvSource({"true, 32000", "false, 32000", "true, 8000"})
    void shouldFillTheLinkAndGiveNothingUp(boolean http2, double bytesPerSecond) throws Exception {
        SessionOptions options = SessionOptions.defaults().withHttp2(http2);
        try (ShapingPipe pipe = ShapingPipe.to(server.uri());
                StreamingSession session =
                        StreamingSession.open(pipe.through(manifest), options, SessionListener.NONE, Runnable::run)) {
            pipe.bytesPerSecond(100_000);
            session.refine(500).join(); // handshake, manifest and base
            pipe.bytesPerSecond(bytesPerSecond);
            session.refine(500).join(); // what was on its way at the former rate
            long carried = pipe.carriedBytes();
            List<RoundReport> rounds = new ArrayList<>();
            for (int i = 0; i < ROUNDS; i++) rounds.add(session.refine(800).join());
            carried = pipe.carriedBytes() - carried;
            long received = rounds.stream().mapToLong(RoundReport::bytes).sum();
            // Frames and records that are not complete yet, and heads, take the rest.
            assertThat((double) received).isGreaterThan(.75 * carried - 8192);
            assertThat(carried).isPositive();
            List<RequestReport> requests = session.trace().requests();
            // A request that the end of the last round left without an answer has no version yet.
            assertThat(requests).filteredOn(r -> r.firstByteMillis() >= 0).allMatch(r -> r.http2() == http2);
            assertThat(requests).hasSizeLessThanOrEqualTo(4 * (ROUNDS + 2));
            assertThat(pipe.connections()).isLessThanOrEqualTo(2);
            assertThatNothingWasGivenUp(requests);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void shouldReadOnWhereAConnectionBroke(boolean http2) throws Exception {
        SessionOptions options = SessionOptions.defaults().withHttp2(http2).withBackoffMillis(5);
        try (ShapingPipe pipe = ShapingPipe.to(server.uri()).bytesPerSecond(100_000);
                StreamingSession session =
                        StreamingSession.open(pipe.through(manifest), options, SessionListener.NONE, Runnable::run)) {
            CompletableFuture<SessionResult> complete = session.complete();
            Await.until("40,000 bytes", () -> session.progress().bytes() >= 40_000);
            pipe.cut();
            pipe.bytesPerSecond(1e9);
            assertThat(complete.join().identical()).isTrue();
            assertThat(pipe.connections()).isEqualTo(2);
            List<RequestReport> requests = session.trace().requests();
            assertThat(requests.stream().skip(1).mapToLong(RequestReport::bytes).sum())
                    .as("zero bytes twice")
                    .isEqualTo(session.progress().bytes());
        }
    }

    /** Records can be read when they are complete: on a connection that is not fast they are short. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void shouldSendShortRecords(boolean http2) throws Exception {
        ByteArrayOutputStream sent = new ByteArrayOutputStream();
        try (ShapingPipe pipe = ShapingPipe.to(server.uri()).copyTo(sent).bytesPerSecond(400_000);
                StreamingSession session = StreamingSession.open(
                        pipe.through(manifest),
                        SessionOptions.defaults().withHttp2(http2),
                        SessionListener.NONE,
                        Runnable::run)) {
            session.refine(300).join();
            session.refine(300).join();
        }
        ByteBuffer records = ByteBuffer.wrap(sent.toByteArray());
        int longest = 0;
        while (records.remaining() > RECORD_HEAD_BYTES) {
            boolean isData = records.get() == DATA_RECORD;
            records.getShort(); // version
            int length = records.getShort();
            if (isData) longest = Math.max(longest, length);
            records.position(Math.min(records.limit(), records.position() + length));
        }
        assertThat(longest).isBetween(2000, ShortRecords.RECORD_BYTES + 64);
    }

    /** Each request begins where the one before ended, and all but the last have brought all that they asked for. */
    private static void assertThatNothingWasGivenUp(List<RequestReport> requests) {
        long at = 0;
        for (int i = 1; i < requests.size(); i++) {
            Matcher m = RANGE.matcher(requests.get(i).range());
            assertThat(m.matches()).isTrue();
            assertThat(Long.parseLong(m.group(1))).isEqualTo(at);
            long asked = Long.parseLong(m.group(2)) + 1 - at;
            if (i < requests.size() - 1)
                assertThat(requests.get(i).bytes()).as("%s", requests.get(i)).isEqualTo(asked);
            at += asked;
        }
    }
}
