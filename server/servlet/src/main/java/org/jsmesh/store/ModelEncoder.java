package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.Path;
import org.jsmesh.mesh.ProgressListener;

/** Makes the archive of a model file. */
@FunctionalInterface
public interface ModelEncoder {
    /**
     * @return the whole archive file
     * @throws IOException when the file cannot be read as a model
     * @throws IllegalArgumentException when the model cannot be encoded
     * @throws java.util.concurrent.CancellationException when the listener cancels
     */
    byte[] encode(Path model, ProgressListener progress) throws IOException;

    /** Names the settings that the bytes depend on. Archives kept under another name are not used. */
    default String settings() {
        return "";
    }
}
