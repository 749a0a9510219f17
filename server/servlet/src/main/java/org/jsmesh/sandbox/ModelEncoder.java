package org.jsmesh.sandbox;

import java.io.IOException;
import java.nio.file.Path;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.mesh.ProgressListener;

/** Makes the archive of a model file. */
@FunctionalInterface
public interface ModelEncoder {
    /**
     * Encodes one model. Several threads may call it at the same time.
     *
     * @param model the file; its companions lie beside it
     * @param archive the file to write, whole or not at all; nothing is there
     * @param progress hears how far the work is and may stop it
     * @return what was read
     * @throws EncodingFailure when there is no archive, with words for people
     * @throws IOException when the file cannot be read as a model
     * @throws IllegalArgumentException when the model cannot be encoded
     * @throws InterruptedException when the thread is interrupted
     * @throws java.util.concurrent.CancellationException when the listener cancels
     */
    ModelInputs encode(Path model, Path archive, ProgressListener progress) throws IOException, InterruptedException;

    /**
     * Names everything but the model that the bytes depend on. Archives kept under another name are not used.
     *
     * @return any text that does not change while the encoder is in use; empty when the model alone decides
     */
    default String settings() {
        return "";
    }
}
