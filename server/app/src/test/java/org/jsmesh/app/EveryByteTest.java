package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.session.SessionListener;
import org.jsmesh.session.SessionOptions;
import org.jsmesh.session.SessionResult;
import org.jsmesh.session.StreamingSession;
import org.jsmesh.session.testing.ProxiedExchange;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.session.testing.StaticFileServer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Connections that end or fall silent at every kind of byte of a model with a texture: none is sent twice, and the
 * original comes.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Timeout(300)
@Tag("slow")
class EveryByteTest {
    @TempDir
    private static Path folder;

    private final Map<String, Long> places = new LinkedHashMap<>();
    private byte[] archive;
    private StaticFileServer server;
    private URI address;

    @BeforeAll
    void encode() throws IOException {
        Path file = folder.resolve("amphora.jsm");
        Cli.ok("encode", Path.of("../../models/amphora.obj"), "-o", file, "--quality", "fast");
        archive = Files.readAllBytes(file);
        BatchIndex index = ArchiveFile.of(archive).header().batches();
        places.put("first byte", 1L);
        places.put("header of the archive", 40L);
        places.put("base", index.end(0) - 20);
        places.put("last byte of the base", index.end(0) - 1);
        places.put("border of base and batch", index.end(0));
        places.put("index", index.end(0) + index.bytes(1) / 2);
        int middle = index.size() / 2;
        places.put("middle of a batch", index.offset(middle) + index.bytes(middle) / 2);
        places.put("border of a batch", index.end(middle));
        int texture = 0;
        while (index.kind(texture) != BatchKind.TEXTURE) texture++;
        places.put("texture", index.offset(texture) + index.bytes(texture) / 2);
        places.put("last byte", archive.length - 1L);
        server = StaticFileServer.withRanges();
        address = server.put("/a.jsm", archive);
    }

    @AfterAll
    void stop() {
        server.close();
    }

    @ParameterizedTest
    @CsvSource({
        "request sent, 0",
        "status line, 5",
        "headers of the answer, 30",
        "first byte, -1",
        "header of the archive, -1",
        "index, -1",
        "base, -1",
        "last byte of the base, -1",
        "border of base and batch, -1",
        "middle of a batch, -1",
        "border of a batch, -1",
        "texture, -1",
        "last byte, -1"
    })
    void shouldGoOnWithTheByteWhereTheConnectionEnded(String place, long headBytes) throws IOException {
        for (boolean silent : new boolean[] {false, true}) {
            try (ShapingProxy proxy = ShapingProxy.to(server.port())) {
                if (silent) proxy.stalling();
                if (headBytes >= 0) proxy.cutHeadAfter(headBytes);
                else proxy.cutAfter(places.get(place));
                SessionOptions options =
                        SessionOptions.defaults().withBackoffMillis(5).withStallMillis(400);
                try (StreamingSession session =
                        StreamingSession.open(proxy.through(address), options, SessionListener.NONE, Runnable::run)) {
                    SessionResult result = session.complete().join();
                    assertThat(result.identical()).isTrue();
                }
                assertThat(proxy.exchanges()).hasSize(2);
                assertThatEveryByteWasSentOnce(proxy.exchanges());
            }
        }
    }

    private void assertThatEveryByteWasSentOnce(List<ProxiedExchange> exchanges) {
        List<ProxiedExchange> bodies = new ArrayList<>(exchanges);
        bodies.removeIf(e -> e.bodyBytes() == 0);
        bodies.sort(Comparator.comparingLong(ProxiedExchange::fromByte));
        long at = 0;
        for (ProxiedExchange e : bodies) {
            assertThat(e.fromByte()).as(e.toString()).isEqualTo(at);
            at += e.bodyBytes();
        }
        assertThat(at).isEqualTo(archive.length);
    }
}
