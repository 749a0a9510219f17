package org.jsmesh.store;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Path;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;

/** Reads model files of every format and encodes them. Their notes go to the log. */
public final class ModelFilesEncoder implements ModelEncoder {
    private static final Logger LOG = System.getLogger(ModelFilesEncoder.class.getName());

    private final EncoderSettings settings;
    private final String build = EncoderBuild.fingerprint();

    /**
     * Makes an encoder.
     *
     * @param settings for every model; the number of threads holds for each one
     */
    public ModelFilesEncoder(EncoderSettings settings) {
        this.settings = settings;
    }

    @Override
    public byte[] encode(Path model, ProgressListener progress) throws IOException {
        EncodedArchive archive = new ModelEncoding(settings).encode(model, progress);
        for (Note note : archive.notes()) LOG.log(Level.INFO, "{0}: {1}", model, note.text());
        return archive.bytes();
    }

    @Override
    public String settings() {
        // The number of threads does not change the bytes.
        return settings.withThreads(1) + " " + build;
    }
}
