package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import org.jsmesh.desktop.dialog.Dialogs;
import org.jsmesh.desktop.draw.Shapes;
import org.jsmesh.desktop.files.UserSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.Await;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** A window on a real screen, with answers to its questions instead of dialogs. */
abstract class WindowFixture {
    static final Mesh MESH = Shapes.paintedTorus(90, 30);
    static final byte[] ARCHIVE = new MeshEncoder(EncoderSettings.defaults())
            .encode(MESH, ProgressListener.NONE)
            .bytes();

    @TempDir
    Path folder;

    final Answers answers = new Answers();
    final UserSettings settings = new UserSettings(null);
    volatile boolean ended;
    Windows windows;
    ViewerWindow window;

    @BeforeAll
    static void needsDisplay() {
        Requirement.display();
    }

    @BeforeEach
    void openWindow() throws Exception {
        on(() -> {
            windows = new Windows(
                    ViewerOptions.defaults().withSize(new PictureSize(640, 400)),
                    settings,
                    parent -> answers,
                    () -> ended = true);
            window = windows.open(null);
            return null;
        });
    }

    @AfterEach
    void closeWindows() throws Exception {
        on(() -> {
            if (settings.isDark()) windows.toggleDark();
            windows.closeAll();
            return null;
        });
    }

    /** Does something on the event dispatch thread, after all that was begun there before. */
    static <T> T on(Callable<T> work) throws Exception {
        FutureTask<T> task = new FutureTask<>(work);
        SwingUtilities.invokeAndWait(task);
        return task.get();
    }

    void open(String location) throws Exception {
        on(() -> {
            window.open(location);
            return null;
        });
    }

    void await(ViewState.Phase phase) throws Exception {
        Await.until(
                "phase " + phase + " instead of " + window.state(),
                () -> on(() -> window.state().phase()) == phase);
    }

    ViewState state() throws Exception {
        return on(() -> window.state());
    }

    /** The text of every label and area that is shown. */
    List<String> words() throws Exception {
        List<String> words = new ArrayList<>();
        for (JLabel label : find(JLabel.class)) words.add(label.getText());
        for (JTextArea area : find(JTextArea.class)) words.add(area.getText());
        return words;
    }

    void press(String button) throws Exception {
        JButton found = find(JButton.class).stream()
                .filter(b -> button.equals(b.getText()))
                .findFirst()
                .orElseThrow();
        assertThat(found.isEnabled()).as(button).isTrue();
        on(() -> {
            found.doClick(0);
            return null;
        });
    }

    /** A key on the picture. */
    void key(int code) throws Exception {
        on(() -> {
            Component picture = window.canvas().component();
            picture.dispatchEvent(new KeyEvent(
                    picture, KeyEvent.KEY_PRESSED, System.currentTimeMillis(), 0, code, KeyEvent.CHAR_UNDEFINED));
            return null;
        });
    }

    /** All that is visible. */
    <T extends Component> List<T> find(Class<T> type) throws Exception {
        return on(() -> {
            List<T> found = new ArrayList<>();
            collect(window.frame(), type, found);
            return found;
        });
    }

    private static <T extends Component> void collect(Component component, Class<T> type, List<T> found) {
        if (!component.isVisible()) return;
        if (type.isInstance(component)) found.add(type.cast(component));
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) collect(child, type, found);
        }
    }

    /** The content of the window as the screen shows it; also written beside the test results, to be looked at. */
    BufferedImage screen(String name) throws Exception {
        Rectangle bounds = on(() -> {
            Container content = window.frame().getContentPane();
            return new Rectangle(content.getLocationOnScreen(), content.getSize());
        });
        BufferedImage picture = new Robot().createScreenCapture(bounds);
        File pictures = new File("target/pictures");
        pictures.mkdirs();
        ImageIO.write(picture, "png", new File(pictures, name + ".png"));
        return picture;
    }

    /** What a user would answer. */
    static final class Answers implements Dialogs {
        final List<String> told = new ArrayList<>();
        List<Path> files = List.of();
        String address;
        Path target;

        @Override
        public List<Path> open(Path folder) {
            return files;
        }

        @Override
        public String address(String suggestion) {
            return address;
        }

        @Override
        public Path save(String title, Path suggestion, boolean isArchive) {
            return target;
        }

        @Override
        public Path savePicture(Path suggestion) {
            return target;
        }

        @Override
        public void tell(String title, String words) {
            told.add(words);
        }
    }
}
