package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import javax.imageio.ImageIO;
import javax.swing.JPanel;
import org.jsmesh.desktop.draw.Shapes;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.session.testing.ShapingProxy;
import org.jsmesh.session.testing.StaticFileServer;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Models in a window, from files and from a server, to what is saved of them. */
class OpenedModelTest extends WindowFixture {
    private static final String DISTANCE = ".*bright is [0-9.]+e?-?[0-9]*";

    private StaticFileServer server;
    private ShapingProxy proxy;

    @BeforeEach
    void serve() throws IOException {
        server = StaticFileServer.withRanges();
        proxy = ShapingProxy.to(server.port());
    }

    @AfterEach
    void stopServing() throws IOException {
        proxy.close();
        server.close();
    }

    @Test
    void shouldOpenTheModelOfAPageAndProveIt() throws Exception {
        server.put("/m/torus/manifest.json", manifest(), "application/json", null);
        server.put("/m/torus/torus.jsm", ARCHIVE);
        proxy.bytesPerSecond(1200);
        open("http://127.0.0.1:" + proxy.port() + "/?m=torus&up=z#camera=1,2,3");
        await(ViewState.Phase.IDLE);
        assertThat(on(() -> window.facts().isShown())).isTrue();
        assertThat(window.actions().moreDetail.isEnabled()).isTrue();
        screen("ready");
        press("Original");
        proxy.bytesPerSecond(1e9);
        await(ViewState.Phase.IDENTICAL);
        assertThat(words()).contains("5,400 of 5,400", "Proof");
        assertThat(words()).anyMatch(text -> text.contains(MeshIdentity.sha256(MESH)));
        assertThat(on(() -> window.frame().getTitle())).isEqualTo("torus – jSM");
        assertThat(settings.recent()).containsExactly("http://127.0.0.1:" + proxy.port() + "/m/torus/manifest.json");
        Await.until("the last step", () -> on(() -> window.canvas().isResting()));
        screen("proved");
    }

    @Test
    void shouldSaveWhatIsShownTheOriginalTheArchiveAndThePicture() throws Exception {
        Path file = Files.write(folder.resolve("torus.jsm"), ARCHIVE);
        open(file.toString());
        await(ViewState.Phase.IDENTICAL);
        key(KeyEvent.VK_OPEN_BRACKET);
        int coarse = on(() ->
                window.facts().header().batches().faces(window.side().detail().shown()));
        assertThat(coarse).isLessThan(MESH.faces());
        save(window.actions().saveShown, "coarse.ply");
        assertThat(ModelFiles.read(folder.resolve("coarse.ply")).mesh().faces()).isEqualTo(coarse);
        save(window.actions().saveOriginal, "whole.obj");
        assertThat(ModelFiles.read(folder.resolve("whole.obj")).mesh().faces()).isEqualTo(MESH.faces());
        save(window.actions().saveArchive, "again.jsm");
        assertThat(folder.resolve("again.jsm")).hasBinaryContent(ARCHIVE);
        save(window.actions().savePicture, "picture.png");
        assertThat(ImageIO.read(folder.resolve("picture.png").toFile()).getWidth())
                .isEqualTo(640);
        key(KeyEvent.VK_CLOSE_BRACKET);
        assertThat((boolean) on(() -> window.side().detail().isNewest())).isTrue();

        answers.target = file;
        on(() -> {
            window.actions().saveArchive.actionPerformed(null);
            return null;
        });
        Await.until("a refusal", () -> words().stream().anyMatch(text -> text.contains("is the model itself")));
        assertThat(file).hasBinaryContent(ARCHIVE);
    }

    @Test
    void shouldMeasureHowFarAnEarlierResolutionIsFromTheNewest() throws Exception {
        open(Files.write(folder.resolve("torus.jsm"), ARCHIVE).toString());
        await(ViewState.Phase.IDENTICAL);
        key(KeyEvent.VK_5);
        assertThat(legend()).contains("Distance to the newest mesh", "this is the newest");
        key(KeyEvent.VK_OPEN_BRACKET);
        Await.until("a distance", () -> legend().matches(DISTANCE));
        key(KeyEvent.VK_4);
        assertThat(legend()).matches("Level of arrival: dark is base mesh, bright is level [0-9]+");
    }

    @Test
    void shouldMeasureAgainWhenANewerMeshHasCome() throws Exception {
        server.put("/torus.jsm", ARCHIVE);
        proxy.bytesPerSecond(1200);
        open("http://127.0.0.1:" + proxy.port() + "/torus.jsm");
        await(ViewState.Phase.IDLE);
        assertThat(on(() -> window.facts().batches())).isGreaterThan(1);
        key(KeyEvent.VK_5);
        key(KeyEvent.VK_OPEN_BRACKET);
        Await.until("a distance", () -> legend().matches(DISTANCE));
        List<String> said = new CopyOnWriteArrayList<>();
        legendPanel().getAccessibleContext().addPropertyChangeListener(e -> said.add(String.valueOf(e.getNewValue())));
        proxy.bytesPerSecond(1e9);
        press("Original");
        await(ViewState.Phase.IDENTICAL);
        Await.until(
                "another distance",
                () -> said.stream().anyMatch(text -> text.contains("measuring")) && legend().matches(DISTANCE));
    }

    @Test
    void shouldShowWhatWentWrongBesideANote() throws Exception {
        open(Files.write(folder.resolve("torus.jsm"), ARCHIVE).toString());
        await(ViewState.Phase.IDENTICAL);
        ViewState before = state();
        on(() -> {
            window.note("Loading the rest, to save a.obj …", false);
            window.show(before.with(ViewState.Phase.RETRYING).withMessage("The connection was lost."));
            return null;
        });
        assertThat(words()).contains("Loading the rest, to save a.obj …\nThe connection was lost.");
    }

    private String legend() throws Exception {
        JPanel panel = legendPanel();
        return panel == null ? "" : panel.getAccessibleContext().getAccessibleName();
    }

    private JPanel legendPanel() throws Exception {
        for (JPanel panel : find(JPanel.class)) {
            String name = panel.getAccessibleContext().getAccessibleName();
            if (name != null && name.contains("bright is")) return panel;
        }
        return null;
    }

    @Test
    void shouldEncodeAModelThatIsDropped() throws Exception {
        Path model = folder.resolve("torus.ply");
        ModelFiles.write(Shapes.torus(40, 20), model, ModelFormat.PLY);
        on(() -> {
            window.open(List.of(model));
            return null;
        });
        await(ViewState.Phase.IDENTICAL);
        assertThat(on(() -> window.facts().progress().faces())).isEqualTo(1600);
        save(window.actions().saveArchive, "made.jsm");
        assertThat(MeshIdentity.sha256(
                        ArchiveFile.read(folder.resolve("made.jsm")).original(ProgressListener.NONE)))
                .isEqualTo(MeshIdentity.sha256(ModelFiles.read(model).mesh()));
    }

    @Test
    void shouldOpenEachOfSeveralInAWindowOfItsOwnAndEndWithTheLast() throws Exception {
        Path one = Files.write(folder.resolve("one.jsm"), ARCHIVE);
        Path other = Files.write(folder.resolve("other.jsm"), ARCHIVE);
        answers.files = List.of(one, other);
        press("Open a file …");
        await(ViewState.Phase.IDENTICAL);
        on(() -> {
            window.frame().dispose();
            return null;
        });
        assertThat(on(() -> ended)).isFalse();
        on(() -> {
            windows.closeAll();
            return null;
        });
        Await.until("the end", () -> ended);
        assertThat(settings.recent()).containsExactly(other.toString(), one.toString());
    }

    @Test
    void shouldTellOfALostConnectionAndTryNow() throws Exception {
        String address = server.put("/torus.jsm", ARCHIVE).toString();
        server.failNext(1, "30");
        open(address);
        await(ViewState.Phase.RETRYING);
        assertThat(words()).contains("Connection lost");
        assertThat(words()).anyMatch(text -> text.contains("503") && text.contains("Attempt 2 follows in 30 s."));
        screen("retrying");
        press("Try now");
        Await.until("a picture", () -> on(() -> window.facts().isShown()));
    }

    @Test
    void shouldTellHowFarTheServerIsWithAModel() throws Exception {
        AtomicInteger asked = new AtomicInteger();
        server.put("/m/torus/torus.jsm", ARCHIVE);
        String address = server.handle("/m/torus/manifest.json", exchange -> {
                    byte[] body = asked.incrementAndGet() == 1
                            ? "{\"stage\":\"collapse\",\"fraction\":0.4}".getBytes(StandardCharsets.UTF_8)
                            : manifest();
                    exchange.getResponseHeaders().set("Content-Type", "application/json");
                    exchange.getResponseHeaders().set("Retry-After", "1");
                    exchange.sendResponseHeaders(asked.get() == 1 ? 202 : 200, body.length);
                    try (OutputStream out = exchange.getResponseBody()) {
                        out.write(body);
                    }
                })
                .toString();
        open(address);
        await(ViewState.Phase.PREPARING);
        assertThat(state().prepared()).isEqualTo(.4);
        assertThat(words()).contains("The server prepares the model: collapse, 40%.");
        Await.until("a picture", () -> on(() -> window.facts().isShown()));
    }

    private void save(javax.swing.Action action, String name) throws Exception {
        answers.target = folder.resolve(name);
        Await.until("an action that is on", action::isEnabled);
        on(() -> {
            action.actionPerformed(null);
            return null;
        });
        Await.until(name, () -> words().stream().anyMatch(text -> text.startsWith("Saved ") && text.contains(name)));
    }

    private static byte[] manifest() {
        String hash = hash(ARCHIVE);
        return ("{\"archiveUrl\":\"torus.jsm\",\"archiveSha256\":\"" + hash + "\",\"meshSha256\":\""
                        + MeshIdentity.sha256(MESH) + "\"}")
                .getBytes(StandardCharsets.UTF_8);
    }

    private static String hash(byte[] bytes) {
        try {
            return ArchiveFile.of(bytes).sha256();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
