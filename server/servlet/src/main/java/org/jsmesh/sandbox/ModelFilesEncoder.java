package org.jsmesh.sandbox;

import java.io.IOException;
import java.nio.file.Path;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.mesh.ProgressListener;

/**
 * Reads model files of every format and encodes them in this process, for hosts that trust their models, or cannot
 * start another process. A model that needs more memory than there is harms whatever else runs in the process.
 */
public final class ModelFilesEncoder implements ModelEncoder {
    private final EncoderSettings settings;

    /**
     * Makes an encoder.
     *
     * @param settings for every model; the number of threads holds for each one
     */
    public ModelFilesEncoder(EncoderSettings settings) {
        this.settings = settings;
    }

    @Override
    public ModelInputs encode(Path model, Path archive, ProgressListener progress) throws IOException {
        ModelInputs inputs = new ModelInputs();
        EncodedArchive encoded = new ModelEncoding(settings).encode(model, inputs, progress);
        progress.step("writing", 0);
        try {
            AtomicFiles.write(archive, encoded::writeTo);
        } catch (IOException e) {
            throw EncodingFailure.noRoom(e);
        }
        return inputs;
    }

    @Override
    public String settings() {
        return settings(settings);
    }

    static String settings(EncoderSettings settings) {
        // The number of threads does not change the bytes.
        return settings.withThreads(1) + " " + ModelEncoding.VERSION;
    }
}
