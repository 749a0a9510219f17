package org.jsmesh.store;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Path;
import java.util.concurrent.ForkJoinPool;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.files.ModelPictures;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFile;

/** Reads model files of every format and encodes them. What was repaired or dropped goes to the log. */
public final class ModelFilesEncoder implements ModelEncoder {
    private static final Logger LOG = System.getLogger(ModelFilesEncoder.class.getName());

    private final EncoderSettings settings;
    private final String build = EncoderBuild.fingerprint();

    public ModelFilesEncoder(EncoderSettings settings) {
        this.settings = settings;
    }

    @Override
    public byte[] encode(Path model, ProgressListener progress) throws IOException {
        ModelFile file = ModelFiles.read(model);
        for (String note : file.notes()) LOG.log(Level.INFO, "{0}: {1}", model, note);
        EncodedArchive archive = new MeshEncoder(settings, ForkJoinPool.commonPool())
                .encode(file.mesh(), ModelPictures.of(file.mesh()), progress);
        for (String note : archive.notes()) LOG.log(Level.INFO, "{0}: {1}", model, note);
        return archive.bytes();
    }

    @Override
    public String settings() {
        // The number of threads does not change the bytes.
        return settings.withThreads(1) + " " + build;
    }
}
