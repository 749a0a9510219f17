package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JProgressBar;
import org.jsmesh.desktop.draw.Camera;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.Pictures;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.Screenshot;
import org.jsmesh.desktop.draw.Shading;
import org.jsmesh.desktop.draw.TextureImages;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.session.SessionProgress;
import org.jsmesh.test.Await;
import org.jsmesh.test.picture.PictureComparison;
import org.junit.jupiter.api.Test;

/** The window as the screen shows it. */
class ViewerWindowTest extends WindowFixture {
    private static final SessionProgress HALF =
            new SessionProgress(54_321, 108_642, 7, 19, 2_700, 5_400, 3, .0123, 1_250_000);

    @Test
    void shouldSayWhatToDoWithoutAModel() throws Exception {
        settings.opened("http://127.0.0.1:8080/m/bunny/manifest.json");
        show(ViewState.EMPTY);
        assertThat(words()).contains("Open a model", "Opened last", "No model");
        assertThat(words()).anyMatch(text -> text.contains("Drop a file on this window"));
        assertThat(find(JButton.class).stream()
                        .filter(button -> button.isEnabled() && button.getText() != null)
                        .map(JButton::getText)
                        .filter(text -> !text.isEmpty()))
                .containsExactlyInAnyOrder(
                        "Open a file …", "Open an address …", "http://127.0.0.1:8080/m/bunny/manifest.json");
        ViewerActions actions = window.actions();
        assertThat(List.of(
                        actions.saveShown,
                        actions.saveOriginal,
                        actions.saveArchive,
                        actions.savePicture,
                        actions.moreDetail,
                        actions.original,
                        actions.stop,
                        actions.tryNow,
                        actions.reload,
                        actions.wireframe,
                        actions.coarser,
                        actions.shadings.get(Shading.LEVELS)))
                .noneMatch(action -> action.isEnabled());
        screen("start");
    }

    @Test
    void shouldDrawTheModelAsTheScreenshotDoes() throws Exception {
        Framing framing = Framing.of(MESH.bounds(), UpAxis.UNKNOWN);
        Scene scene = Scene.of(MESH, Pictures.CREASE, false, framing, new TextureImages());
        on(() -> {
            window.frame(framing);
            window.show(scene);
            window.show(new ViewState(ViewState.Phase.IDLE, HALF, 8, null));
            return null;
        });
        BufferedImage expected = Screenshot.take(scene, Camera.framing(framing, 640, 400), 640, 400, true);
        BitSet all = new BitSet();
        all.set(0, 640 * 400);
        // Graphics drivers are allowed to differ between a window and an offscreen buffer.
        Await.until("the picture", () -> PictureComparison.meanDifference(canvas(screen("window")), expected, all) < 1);
    }

    @Test
    void shouldSayHowFarTheSessionIs() throws Exception {
        show(new ViewState(ViewState.Phase.IDLE, HALF, 8, null));
        assertThat(words())
                .contains(
                        "Ready",
                        "2,700 of 5,400 faces  ·  54 kB of 109 kB  ·  1.3 MB/s  ·  level 3 of 8  ·  error 0.012%");
        assertThat(find(JProgressBar.class).get(0).getPercentComplete()).isEqualTo(.5);
        show(new ViewState(ViewState.Phase.IDENTICAL, HALF, 8, null));
        assertThat(words()).contains("✓ identical to the original");
        assertThat(window.actions().moreDetail.isEnabled()).isFalse();
        show(new ViewState(ViewState.Phase.INCOMPLETE, HALF, 8, "Not the whole original: 1 face missing."));
        assertThat(words())
                .contains("⚠ not the whole original", "Not the whole original: 1 face missing.")
                .doesNotContain("✓ identical to the original");
        show(new ViewState(ViewState.Phase.IDLE, null, 0, null));
        assertThat(words()).contains("Nothing has arrived yet").doesNotContain("Opening …");
        show(ViewState.START.preparing("The server prepares the model: collapse, 40%.", .4));
        assertThat(find(JProgressBar.class).get(0).getPercentComplete()).isEqualTo(.4);
        assertThat(words()).contains("Preparing …", "The server prepares the model: collapse, 40%.");
    }

    @Test
    void shouldSayWhyThereIsNoPictureAndWhatToDo() throws Exception {
        open(folder.resolve("none.jsm").toString());
        await(ViewState.Phase.ERROR);
        assertThat(words()).contains("The model cannot be shown", "Stopped");
        assertThat(words()).anyMatch(text -> text.contains("none.jsm") && text.contains("does not exist"));
        assertThat(window.actions().moreDetail.isEnabled()).isTrue();
        screen("error");
        open(Files.writeString(folder.resolve("bad.ply"), "ply\nformat ascii 1.0\nelement vertex x\n")
                .toString());
        Await.until(
                "bad.ply in words",
                () -> words().stream().anyMatch(text -> text.contains("bad.ply") && text.contains("line")));
        open("ftp://h/model.jsm");
        assertThat(words()).anyMatch(text -> text.contains("ftp://h/model.jsm is no http, https or file address"));
    }

    @Test
    void shouldSayWhyNothingCanBeDrawnWhateverTheSessionTells() throws Exception {
        on(() -> {
            window.cannotDraw("The graphics driver refuses the shader mesh.");
            return null;
        });
        show(new ViewState(ViewState.Phase.IDLE, HALF, 8, null));
        assertThat(words()).contains("The graphics driver refuses the shader mesh.", "Ready");
        open(Files.write(folder.resolve("torus.jsm"), ARCHIVE).toString());
        await(ViewState.Phase.IDENTICAL);
        assertThat(words()).contains("The graphics driver refuses the shader mesh.", "✓ identical to the original");
        on(() -> {
            window.cannotDraw(null);
            return null;
        });
        assertThat(words()).doesNotContain("The graphics driver refuses the shader mesh.");
    }

    @Test
    void shouldChangeItsLookAtOnce() throws Exception {
        BufferedImage light = screen("light");
        on(() -> {
            windows.toggleDark();
            return null;
        });
        assertThat(settings.isDark()).isTrue();
        Await.until("a dark window", () -> brightness(screen("dark")) < brightness(light) - 100);
    }

    @Test
    void shouldShadeByKeysAndMenus() throws Exception {
        Path file = Files.write(folder.resolve("torus.jsm"), ARCHIVE);
        open(file.toString());
        await(ViewState.Phase.IDENTICAL);
        key(KeyEvent.VK_W);
        key(KeyEvent.VK_4);
        assertThat(on(() -> window.canvas().style().wireframe())).isTrue();
        assertThat(on(() -> window.canvas().style().shading())).isEqualTo(Shading.LEVELS);
        assertThat(words()).contains("Colours");
        key(KeyEvent.VK_W);
        key(KeyEvent.VK_1);
        assertThat(on(() -> window.canvas().style().wireframe())).isFalse();
        assertThat(words()).doesNotContain("Colours").contains("Level of detail");
        Camera framed = on(() -> window.canvas().camera());
        key(KeyEvent.VK_RIGHT);
        assertThat(on(() -> window.canvas().camera())).isNotEqualTo(framed);
        key(KeyEvent.VK_HOME);
        Await.until(
                "all of the model", () -> framed.equals(on(() -> window.canvas().camera())));
        key(KeyEvent.VK_F9);
        assertThat(words()).doesNotContain("Level of detail");
        assertThat(settings.isPanelShown()).isFalse();
        key(KeyEvent.VK_F1);
        assertThat(answers.told).singleElement().asString().contains("Space refines");
    }

    private void show(ViewState next) throws Exception {
        on(() -> {
            window.show(next);
            return null;
        });
    }

    private static double brightness(BufferedImage picture) {
        Color corner = new Color(picture.getRGB(picture.getWidth() - 5, picture.getHeight() - 5));
        return (corner.getRed() + corner.getGreen() + corner.getBlue()) / 3.0;
    }

    private static BufferedImage canvas(BufferedImage content) {
        return content.getSubimage(0, 0, 640, 400);
    }
}
