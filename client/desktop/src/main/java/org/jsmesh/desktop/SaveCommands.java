package org.jsmesh.desktop;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;
import org.jsmesh.desktop.dialog.Dialogs;
import org.jsmesh.desktop.files.ModelAddress;
import org.jsmesh.desktop.files.UserSettings;
import org.jsmesh.desktop.panel.ModelFacts;

/** Asks where to save, loads what is missing, and saves in the background. Used on the event dispatch thread. */
final class SaveCommands {
    private final Dialogs dialogs;
    private final UserSettings settings;
    private final Background background;
    private final BiConsumer<String, Boolean> note;

    /**
     * @param background where models are saved
     * @param note says what became of it, and whether it failed
     */
    SaveCommands(Dialogs dialogs, UserSettings settings, Background background, BiConsumer<String, Boolean> note) {
        this.dialogs = dialogs;
        this.settings = settings;
        this.background = background;
        this.note = note;
    }

    /**
     * Saves a model.
     *
     * @param batch after which the resolution on the screen is
     * @param facts what is known when everything that is needed has come
     */
    void save(Saving.What what, ModelRun run, int batch, Supplier<ModelFacts> facts) {
        if (run == null) return;
        String extension = what == Saving.What.ARCHIVE ? ".jsm" : what == Saving.What.SHOWN ? ".glb" : ".obj";
        String title = switch (what) {
            case SHOWN -> "Save what is shown";
            case ORIGINAL -> "Save the original";
            case ARCHIVE -> "Save the archive";
        };
        Path file = dialogs.save(title, suggestion(run.address(), extension), what == Saving.What.ARCHIVE);
        if (file == null) return;
        settings.used(file);
        ModelFacts now = facts.get();
        if (what == Saving.What.SHOWN) {
            write(what, file, run.address(), now, batch);
            return;
        }
        if (now.result() == null) note.accept("Loading the rest, to save " + file.getFileName() + " …", false);
        run.whenComplete(() -> write(what, file, run.address(), facts.get(), batch));
    }

    private void write(Saving.What what, Path file, ModelAddress from, ModelFacts facts, int batch) {
        note.accept("Saving " + file.getFileName() + " …", false);
        background.run("jsm-save", () -> {
            try {
                String words = Saving.write(what, file, from, facts, batch);
                SwingUtilities.invokeLater(() -> note.accept("Saved " + words, false));
            } catch (RuntimeException | OutOfMemoryError e) {
                String words = e instanceof ViewerException ? e.getMessage() : SessionView.trouble(file.toString(), e);
                SwingUtilities.invokeLater(() -> note.accept(words, true));
            }
        });
    }

    /** Saves what the canvas shows. */
    void savePicture(ModelAddress from, SceneCanvas canvas) {
        Path file = dialogs.savePicture(suggestion(from, ".png"));
        if (file == null) return;
        settings.used(file);
        try {
            Saving.requireOther(file, from);
            PictureSize size = canvas.size();
            BufferedImage picture = canvas.picture(size.width(), size.height(), true);
            if (picture == null)
                throw new ViewerException(file + ": nothing is written, because nothing can be drawn now");
            ScreenshotRun.write(picture, file.toFile());
            note.accept("Saved " + file + ": " + picture.getWidth() + " × " + picture.getHeight() + " pixels.", false);
        } catch (ViewerException | IllegalArgumentException | IOException e) {
            note.accept(SessionView.words(e), true);
        }
    }

    private Path suggestion(ModelAddress from, String extension) {
        Path folder = settings.folder();
        Path file = Path.of(from.fileName() + extension);
        return folder == null ? file : folder.resolve(file);
    }
}
