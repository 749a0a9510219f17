package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.Shapes;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.session.testing.StaticFileServer;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(value = 120, unit = TimeUnit.SECONDS)
class ViewerSessionTest {
    private static final Mesh ORIGINAL = Shapes.paintedTorus(100, 40);
    private static byte[] archive;

    @TempDir
    private Path folder;

    private final Recorder display = new Recorder();

    @BeforeAll
    static void encode() {
        archive = new MeshEncoder(EncoderSettings.defaults())
                .encode(ORIGINAL, ProgressListener.NONE)
                .bytes();
    }

    @Test
    void shouldShowTheOriginalOfAFileAndProveIt() throws Exception {
        stream(archive);
        assertThat(display.last().phase()).isEqualTo(ViewState.Phase.IDENTICAL);
        assertThat(display.last().progress().fraction()).isEqualTo(1);
        assertThat(display.framing).isEqualTo(Framing.of(ORIGINAL.bounds(), UpAxis.UNKNOWN));
        assertThat(display.faces.get(display.faces.size() - 1)).isEqualTo(ORIGINAL.faces());
        assertThat(display.faces).isSorted();
    }

    @Test
    void shouldBringAllOfAFileWithinARoundAndCallNothingThroughput() throws Exception {
        Path file = Files.write(folder.resolve("model.jsm"), archive);
        assertThat(archive.length).isGreaterThan(16_384);
        try (ViewerSession session = new ViewerSession(file.toString(), null, display)) {
            session.refine(100_000).join();
        }
        assertThat(display.last().phase()).isEqualTo(ViewState.Phase.IDENTICAL);
        assertThat(display.last().progress().bytesPerSecond()).isZero();
    }

    @Test
    void shouldKeepTheMeshOfADamagedFileAndNameTheDamage() throws Exception {
        byte[] damaged = archive.clone();
        damaged[archive.length - 10] ^= 4;
        stream(damaged);
        assertThat(display.last().phase()).isEqualTo(ViewState.Phase.ERROR);
        assertThat(display.last().message()).contains("model.jsm", "byte ", "fetch it again");
        assertThat(display.faces).isNotEmpty();
        assertThat(display.states).noneMatch(s -> s.phase() == ViewState.Phase.IDENTICAL);
    }

    @Test
    void shouldSayThatAFileIsMissing() {
        try (ViewerSession session =
                new ViewerSession(folder.resolve("none.jsm").toString(), null, display)) {
            session.refine(1000).join();
        }
        assertThat(display.last().phase()).isEqualTo(ViewState.Phase.ERROR);
        assertThat(display.last().message()).contains("none.jsm", "does not exist");
    }

    @Test
    void shouldRefuseOtherKindsOfAddress() {
        assertThatThrownBy(() -> new ViewerSession("ftp://example.org/model.jsm", null, display))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("ftp://example.org/model.jsm");
        assertThatThrownBy(() -> new ViewerSession("http://exa mple/", null, display))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("no address");
    }

    @Test
    void shouldShowTheNewModelWhenItChangesInTheMiddle() throws Exception {
        Mesh other = Shapes.paintedTorus(60, 30);
        byte[] next = new MeshEncoder(EncoderSettings.defaults())
                .encode(other, ProgressListener.NONE)
                .bytes();
        try (StaticFileServer server = StaticFileServer.withRanges()) {
            String address = server.put("/model.jsm", archive).toString();
            try (ViewerSession session = new ViewerSession(address, folder.resolve("cache"), display)) {
                session.refine(1).join();
                assertThat(display.last().progress().isComplete()).isFalse();
                server.put("/model.jsm", next);
                session.complete().join();
            }
        }
        assertThat(display.last().phase()).isEqualTo(ViewState.Phase.IDENTICAL);
        assertThat(display.last().message()).contains("changed on the server", "This is the new one");
        assertThat(display.faces.get(display.faces.size() - 1)).isEqualTo(other.faces());
        assertThat(display.framing).isEqualTo(Framing.of(other.bounds(), UpAxis.UNKNOWN));
    }

    @Test
    void shouldStayIdenticalWhenAnEarlierResolutionCannotBeShown() throws Exception {
        Path file = Files.write(folder.resolve("model.jsm"), archive);
        try (ViewerSession session = new ViewerSession(file.toString(), null, display)) {
            session.complete().join();
            session.showEarlier(0, 0, null);
            Await.until("a reason", () -> display.reason != null);
        }
        assertThat(display.reason).startsWith(file.toString());
        assertThat(display.last().phase()).isEqualTo(ViewState.Phase.IDENTICAL);
    }

    private void stream(byte[] bytes) throws Exception {
        Path file = Files.write(folder.resolve("model.jsm"), bytes);
        try (ViewerSession session = new ViewerSession(file.toUri().toString(), null, display)) {
            session.refine(1).join();
            session.complete().join();
        }
    }

    private static final class Recorder implements SessionView.Display {
        final List<ViewState> states = new CopyOnWriteArrayList<>();
        final List<Integer> faces = new CopyOnWriteArrayList<>();
        volatile Framing framing;
        volatile String reason;

        ViewState last() {
            return states.get(states.size() - 1);
        }

        @Override
        public void frame(Framing next) {
            framing = next;
        }

        @Override
        public void showNoEarlier(String words) {
            reason = words;
        }

        @Override
        public void show(Scene scene) {
            faces.add(scene.mesh().faces());
        }

        @Override
        public void show(ViewState state) {
            states.add(state);
        }
    }
}
