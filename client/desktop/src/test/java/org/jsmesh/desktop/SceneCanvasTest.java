package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.jsmesh.desktop.draw.Camera;
import org.jsmesh.desktop.draw.ErrorMap;
import org.jsmesh.desktop.draw.Pictures;
import org.jsmesh.desktop.draw.Scene;
import org.jsmesh.desktop.draw.Screenshot;
import org.jsmesh.desktop.draw.Shapes;
import org.jsmesh.desktop.draw.TestSteps;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.Await;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.picture.PictureComparison;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class SceneCanvasTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 240;
    private static TestSteps steps;

    private final List<String> errors = new ArrayList<>();
    private JFrame frame;
    private SceneCanvas canvas;

    @BeforeAll
    static void encode() throws Exception {
        Requirement.display();
        steps = new TestSteps(
                new MeshEncoder(EncoderSettings.defaults()).encode(Shapes.paintedTorus(90, 30), ProgressListener.NONE),
                4);
    }

    @BeforeEach
    void open() throws Exception {
        on(() -> {
            canvas = new SceneCanvas(errors::add);
            CameraControls.install(canvas);
            canvas.component().setPreferredSize(new Dimension(WIDTH, HEIGHT));
            frame = new JFrame();
            frame.add(canvas.component());
            frame.pack();
            frame.setVisible(true);
            canvas.frame(steps.framing);
            steps.steps.forEach(canvas::show);
            return null;
        });
        while (on(() -> !canvas.isResting() || canvas.camera() == null)) Thread.sleep(20);
    }

    @AfterEach
    void close() throws Exception {
        on(() -> {
            frame.dispose();
            return null;
        });
        assertThat(errors).isEmpty();
    }

    /** On the event dispatch thread. */
    private static <T> T on(Callable<T> work) throws Exception {
        FutureTask<T> task = new FutureTask<>(work);
        SwingUtilities.invokeAndWait(task);
        return task.get();
    }

    private void send(int type, int button, int x, int y, int clicks, int modifiers) throws Exception {
        Component c = canvas.component();
        on(() -> {
            c.dispatchEvent(new MouseEvent(c, type, 0, modifiers, x, y, clicks, false, button));
            return null;
        });
    }

    private void wheel(int x, int y, double rotation) throws Exception {
        Component c = canvas.component();
        on(() -> {
            c.dispatchEvent(new MouseWheelEvent(
                    c, MouseEvent.MOUSE_WHEEL, 0, 0, x, y, 0, 0, 0, false, 0, 1, (int) rotation, rotation));
            return null;
        });
    }

    private double[] beneath(int x, int y) throws Exception {
        return on(() -> canvas.pick(2 * (x + .5) / WIDTH - 1, 1 - 2 * (y + .5) / HEIGHT));
    }

    @Test
    void shouldShowTheLastStepAtAnySize() throws Exception {
        BufferedImage picture = on(() -> canvas.picture(400, 200, true));
        Camera camera = Camera.framing(steps.framing, 400, 200);
        BufferedImage expected = Screenshot.take(steps.whole(steps.meshes.size() - 1), camera, 400, 200, true);
        assertThat(PictureComparison.meanDifference(picture, expected, PictureComparison.opaque(expected)))
                .isLessThan(.5);
        assertThat(on(() -> canvas.lastLevel())).isPositive();
    }

    @Test
    void shouldKeepWhatIsBeneathThePointerWhenTheWheelIsTurned() throws Exception {
        int x = 100;
        int y = 140;
        double[] before = beneath(x, y);
        assertThat(before).isNotNull();
        double distance = on(() -> canvas.camera().distance());
        for (int i = 0; i < 6; i++) wheel(x, y, -1);
        assertThat(on(() -> canvas.camera().distance())).isLessThan(.7 * distance);
        assertThat(beneath(x, y)).containsExactly(before, within(.01));
        send(MouseEvent.MOUSE_CLICKED, MouseEvent.BUTTON1, x, y, 2, 0);
        while (on(() -> canvas.camera() == null)) Thread.sleep(20);
        assertThat(on(() -> canvas.camera().distance())).isEqualTo(distance);
    }

    @Test
    void shouldCarryWhatIsBeneathThePointerWhenPanning() throws Exception {
        double[] before = beneath(100, 140);
        send(MouseEvent.MOUSE_PRESSED, MouseEvent.BUTTON3, 100, 140, 1, InputEvent.BUTTON3_DOWN_MASK);
        send(MouseEvent.MOUSE_DRAGGED, MouseEvent.BUTTON3, 130, 120, 0, InputEvent.BUTTON3_DOWN_MASK);
        assertThat(beneath(130, 120)).containsExactly(before, within(.01));
    }

    @Test
    void shouldTurnByKeysAndDrawEdges() throws Exception {
        double yaw = on(() -> canvas.camera().yaw());
        key(KeyEvent.VK_RIGHT);
        assertThat(on(() -> canvas.camera().yaw())).isGreaterThan(yaw);
        BufferedImage plain = on(() -> canvas.picture(WIDTH, HEIGHT, false));
        on(() -> {
            canvas.style(canvas.style().withWireframe(true));
            return null;
        });
        BufferedImage wired = on(() -> canvas.picture(WIDTH, HEIGHT, false));
        Pictures.keep("canvas-wired", wired);
        assertThat(PictureComparison.meanDifference(plain, wired, PictureComparison.opaque(plain)))
                .isGreaterThan(5);
    }

    @Test
    void shouldRefineOnlyWhereThereIsAWindow() throws Exception {
        on(() -> {
            steps.steps.forEach(canvas::show);
            frame.dispose();
            return null;
        });
        assertThat(on(() -> canvas.isRefining())).isFalse();
        on(() -> {
            canvas.show(steps.steps.get(0));
            return null;
        });
        Await.until("no more parts", () -> on(() -> !canvas.isRefining()));
        assertThat(on(() -> canvas.isResting())).isFalse();
        on(() -> {
            frame.setVisible(true);
            return null;
        });
        Await.until("all steps", () -> on(() -> canvas.isResting()));
    }

    @Test
    void shouldKeepTheSceneOnTheCardWhenErrorsCome() throws Exception {
        Scene scene = steps.whole(0);
        on(() -> {
            canvas.show(scene);
            return null;
        });
        BufferedImage before = on(() -> canvas.picture(WIDTH, HEIGHT, false));
        // Whoever brought the scene to the card again would bring this.
        Arrays.fill(scene.mesh().positions(), 0);
        on(() -> {
            canvas.show((ErrorMap) null);
            return null;
        });
        BufferedImage after = on(() -> canvas.picture(WIDTH, HEIGHT, false));
        assertThat(PictureComparison.meanDifference(before, after, PictureComparison.opaque(before)))
                .isZero();
    }

    @Test
    void shouldLeaveKeysOfMenusToThem() throws Exception {
        assertThat(key(KeyEvent.VK_LEFT)).isTrue();
        assertThat(key(KeyEvent.VK_W)).isFalse();
        assertThat(key(KeyEvent.VK_HOME)).isFalse();
    }

    /** Whether it was for the camera. */
    private boolean key(int code) throws Exception {
        Component c = canvas.component();
        KeyEvent key = new KeyEvent(c, KeyEvent.KEY_PRESSED, 0, 0, code, KeyEvent.CHAR_UNDEFINED);
        return on(() -> {
            c.dispatchEvent(key);
            return key.isConsumed();
        });
    }
}
