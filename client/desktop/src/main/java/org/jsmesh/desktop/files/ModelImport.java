package org.jsmesh.desktop.files;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;

/**
 * An archive that was made of a model file, in a folder of its own that goes with it.
 *
 * @param archive the file
 * @param notes what of the model was mended or lost
 */
public record ModelImport(Path archive, List<Note> notes) implements AutoCloseable {
    /**
     * Copies the notes.
     *
     * @param archive see {@link #archive()}
     * @param notes see {@link #notes()}
     */
    public ModelImport {
        notes = List.copyOf(notes);
    }

    /**
     * Encodes a model as {@code jsm encode} does.
     *
     * @param model a file of any format that {@link ModelEncoding} reads
     * @param progress hears how far the work is and may stop it
     * @return the archive, to be closed by the caller
     * @throws IOException when the model cannot be read, or the archive not be written
     * @throws IllegalArgumentException when the model cannot be encoded
     * @throws java.util.concurrent.CancellationException when the listener cancels
     */
    public static ModelImport of(Path model, ProgressListener progress) throws IOException {
        return of(model, Path.of(System.getProperty("java.io.tmpdir")), progress);
    }

    /** @param place where the archive's folder is made */
    static ModelImport of(Path model, Path place, ProgressListener progress) throws IOException {
        Path folder = Files.createTempDirectory(place, "jsm-viewer");
        boolean done = false;
        try {
            Path archive = folder.resolve(model.toAbsolutePath().getFileName() + ".jsm");
            List<Note> notes = new ModelEncoding(EncoderSettings.defaults())
                    .write(model, archive, progress)
                    .notes();
            done = true;
            return new ModelImport(archive, notes);
        } finally {
            if (!done) delete(folder);
        }
    }

    /** Removes the archive. */
    @Override
    public void close() {
        delete(archive.getParent());
    }

    private static void delete(Path folder) {
        try (Stream<Path> found = Files.walk(folder)) {
            for (Path path : found.sorted(Comparator.reverseOrder()).toList()) Files.deleteIfExists(path);
        } catch (IOException | UncheckedIOException e) {
            // The system empties its folder for temporary files.
        }
    }
}
