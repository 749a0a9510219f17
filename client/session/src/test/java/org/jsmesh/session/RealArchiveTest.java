package org.jsmesh.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.URI;
import java.util.List;
import java.util.Random;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.Texture;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.session.testing.StaticFileServer;
import org.jsmesh.test.AlteredPicture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(120)
class RealArchiveTest {
    private static final SessionOptions QUICK =
            SessionOptions.defaults().withBackoffMillis(5).withMeshMillis(0);
    private static Mesh original;
    private static EncodedArchive encoded;
    private StaticFileServer server;
    private ShapingProxy proxy;
    private URI address;

    @BeforeAll
    static void encode() {
        original = torus(80, 100);
        encoded = new MeshEncoder(EncoderSettings.defaults()).encode(original, ProgressListener.NONE);
    }

    @BeforeEach
    void start() throws IOException {
        server = StaticFileServer.withRanges();
        proxy = ShapingProxy.to(server.port());
        String hash = FakeArchive.sha256(encoded.bytes());
        address = proxy.through(server.put("/m/torus/" + hash + ".jsm", encoded.bytes()));
    }

    @AfterEach
    void stop() throws IOException {
        proxy.close();
        server.close();
    }

    /** A ring with bumps, so that no two places are alike. */
    static Mesh torus(int rings, int segments) {
        float[] positions = new float[3 * rings * segments];
        int[] faces = new int[6 * rings * segments];
        for (int i = 0; i < rings; i++) {
            for (int j = 0; j < segments; j++) {
                double u = 2 * Math.PI * i / rings;
                double v = 2 * Math.PI * j / segments;
                double r = 1 + 0.2 * Math.sin(3 * u + v) + 0.05 * Math.cos(7 * v);
                int at = i * segments + j;
                positions[3 * at] = (float) ((3 + r * Math.cos(v)) * Math.cos(u));
                positions[3 * at + 1] = (float) ((3 + r * Math.cos(v)) * Math.sin(u));
                positions[3 * at + 2] = (float) (r * Math.sin(v));
                int right = (i + 1) % rings * segments + j;
                int up = i * segments + (j + 1) % segments;
                int both = (i + 1) % rings * segments + (j + 1) % segments;
                int[] two = {at, right, both, at, both, up};
                System.arraycopy(two, 0, faces, 6 * at, 6);
            }
        }
        return new MeshBuilder().positions(positions).faceWedges(faces).build();
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void shouldBringTheOriginalThroughABrokenConnectionWithoutSendingAByteTwice(long seed) {
        proxy.cutAfter(new Random(seed).nextInt(encoded.bytes().length));
        try (StreamingSession session = StreamingSession.open(address, QUICK, SessionListener.NONE, Runnable::run)) {
            SessionResult result = session.complete().join();
            assertThat(result.identical()).isTrue();
            assertThat(result.meshSha256()).isEqualTo(MeshIdentity.sha256(original));
            assertThat(result.mesh().faces()).isEqualTo(original.faces());
        }
        assertThat(proxy.exchanges().size()).isGreaterThan(1);
        SessionFixture.assertTiling(proxy.exchanges(), encoded.bytes().length);
    }

    @Test
    void shouldShowTheBaseEarlyAndMoreAfterEachRound() {
        int whole = encoded.bytes().length;
        proxy.bytesPerSecond(whole / 3.0);
        Recording heard = new Recording();
        try (StreamingSession session = StreamingSession.open(address, QUICK, heard, Runnable::run)) {
            RoundReport first = session.refine(500).join();
            Mesh coarse = session.snapshot().join();
            RoundReport second = session.refine(500).join();
            assertThat(first.faces()).isPositive().isLessThan(original.faces());
            assertThat(coarse.faces()).isGreaterThanOrEqualTo(first.faces());
            assertThat(second.faces()).isGreaterThanOrEqualTo(first.faces());
            assertThat(second.bytes()).isPositive();
            assertThat(session.header().meshSha256()).isEqualTo(MeshIdentity.sha256(original));
        }
        assertThat(heard.facesShown).isSorted();
        assertThat(heard.progress.get(0).bytes()).isLessThan(whole / 3);
    }

    @Test
    void shouldNotCallIdenticalWhosePictureWasAltered() throws Exception {
        Mesh painted = MeshBuilder.from(torus(8, 10))
                .textures(List.of(new Texture("wood.png", new byte[500])))
                .build();
        byte[] whole = new MeshEncoder(EncoderSettings.defaults())
                .encode(painted, ProgressListener.NONE)
                .bytes();
        assertThat(complete(whole).identical()).isTrue();
        SessionResult result = complete(AlteredPicture.in(whole));
        assertThat(result.identical()).isFalse();
        assertThat(result.difference()).isEqualTo("the picture wood.png is not the one that was encoded");
    }

    private SessionResult complete(byte[] archive) {
        URI painted = server.put("/painted.jsm", archive);
        try (StreamingSession session = StreamingSession.open(painted, QUICK, SessionListener.NONE, Runnable::run)) {
            return session.complete().join();
        }
    }

    @Test
    void shouldNeverCallDamagedBytesIdentical() {
        Random random = new Random(7);
        for (int i = 0; i < 20; i++) {
            proxy.corruptByte(random.nextInt(encoded.bytes().length));
            try (StreamingSession session =
                    StreamingSession.open(address, QUICK, SessionListener.NONE, Runnable::run)) {
                assertThatThrownBy(() -> session.complete().join()).hasCauseInstanceOf(MalformedStreamException.class);
                assertThat(session.result()).isNull();
            }
        }
    }
}
