package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.image.BufferedImage;
import java.io.File;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JProgressBar;
import javax.swing.SwingUtilities;
import org.jsmesh.desktop.draw.Camera;
import org.jsmesh.desktop.draw.Framing;
import org.jsmesh.desktop.draw.Pictures;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.Screenshot;
import org.jsmesh.desktop.draw.Shapes;
import org.jsmesh.desktop.draw.TextureImages;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.session.SessionProgress;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.picture.PictureComparison;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The window as the screen shows it. */
class ViewerWindowTest {
    private static final Mesh MESH = Shapes.paintedTorus(90, 30);
    private static final SessionProgress HALF =
            new SessionProgress(54_321, 108_642, 7, 19, 2_700, 5_400, 3, .0123, 1_250_000);

    private final List<String> requests = new ArrayList<>();
    private ViewerWindow window;

    @BeforeAll
    static void needsDisplay() {
        Requirement.display();
        FlatLightLaf.setup();
    }

    @BeforeEach
    void open() throws Exception {
        SwingUtilities.invokeAndWait(
                () -> window = new ViewerWindow("torus.jsm", "2 s", new PictureSize(640, 400), new Requests()));
    }

    @AfterEach
    void close() throws Exception {
        SwingUtilities.invokeAndWait(() -> window.frame().dispose());
    }

    @Test
    void shouldDrawTheModelAsTheScreenshotDoes() throws Exception {
        Framing framing = Framing.of(MESH.bounds(), UpAxis.UNKNOWN);
        Scene scene = Scene.of(MESH, Pictures.CREASE, false, framing, new TextureImages());
        window.frame(framing);
        window.show(scene);
        window.show(new ViewState(ViewState.Phase.IDLE, HALF, 8, null));
        BufferedImage expected = Screenshot.take(scene, Camera.framing(framing, 640, 400), 640, 400, true);
        BitSet all = new BitSet();
        all.set(0, 640 * 400);
        BufferedImage shown = screen("window");
        // Graphics drivers are allowed to differ between a window and an offscreen buffer.
        for (int i = 0; i < 50 && PictureComparison.meanDifference(canvas(shown), expected, all) > 1; i++) {
            Thread.sleep(100);
            shown = screen("window");
        }
        assertThat(PictureComparison.meanDifference(canvas(shown), expected, all))
                .isLessThan(1);
    }

    @Test
    void shouldSayHowFarTheSessionIs() throws Exception {
        window.show(new ViewState(ViewState.Phase.IDLE, HALF, 8, null));
        assertThat(labels())
                .contains(
                        "Ready",
                        "2,700 of 5,400 faces  ·  54 kB of 109 kB  ·  1.3 MB/s  ·  level 3 of 8  ·  error 0.012%");
        assertThat(find(JProgressBar.class).get(0).getPercentComplete()).isEqualTo(.5);
        window.show(new ViewState(ViewState.Phase.IDENTICAL, HALF, 8, null));
        assertThat(labels()).contains("✓ identical to the original");
        assertThat(buttons()).noneMatch(JButton::isEnabled);
        window.show(new ViewState(ViewState.Phase.INCOMPLETE, HALF, 8, "Not the whole original: 1 face missing."));
        assertThat(labels()).contains("⚠ not the whole original").doesNotContain("✓ identical to the original");
    }

    @Test
    void shouldAskForMoreOncePerRound() throws Exception {
        window.show(new ViewState(ViewState.Phase.IDLE, HALF, 8, null));
        click(0);
        click(1);
        assertThat(requests).containsExactly("more detail");
        window.show(new ViewState(ViewState.Phase.ERROR, HALF, 8, "http://x/: connection refused; try again"));
        click(1);
        assertThat(requests).containsExactly("more detail", "original");
    }

    private final class Requests implements ViewerWindow.Requests {
        @Override
        public void moreDetail() {
            requests.add("more detail");
        }

        @Override
        public void original() {
            requests.add("original");
        }

        @Override
        public void close() {
            requests.add("close");
        }
    }

    private void click(int button) throws Exception {
        List<JButton> buttons = buttons();
        SwingUtilities.invokeAndWait(() -> buttons.get(button).doClick(0));
    }

    private List<JButton> buttons() throws Exception {
        return find(JButton.class);
    }

    private List<String> labels() throws Exception {
        return find(JLabel.class).stream().map(JLabel::getText).toList();
    }

    /** After everything that was asked for before has been done. */
    private <T extends Component> List<T> find(Class<T> type) throws Exception {
        List<T> found = new ArrayList<>();
        SwingUtilities.invokeAndWait(() -> collect(window.frame(), type, found));
        return found;
    }

    private static <T extends Component> void collect(Component component, Class<T> type, List<T> found) {
        if (type.isInstance(component)) found.add(type.cast(component));
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) collect(child, type, found);
        }
    }

    private BufferedImage screen(String name) throws Exception {
        AtomicReference<Rectangle> bounds = new AtomicReference<>();
        SwingUtilities.invokeAndWait(() -> {
            Container content = window.frame().getContentPane();
            bounds.set(new Rectangle(content.getLocationOnScreen(), content.getSize()));
        });
        BufferedImage picture = new Robot().createScreenCapture(bounds.get());
        File folder = new File("target/pictures");
        folder.mkdirs();
        ImageIO.write(picture, "png", new File(folder, name + ".png"));
        return picture;
    }

    private static BufferedImage canvas(BufferedImage content) {
        return content.getSubimage(0, 0, 640, 400);
    }
}
