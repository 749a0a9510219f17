package org.jsmesh.upload;

import java.io.IOException;
import java.nio.file.Path;
import org.jsmesh.mesh.ProgressListener;

/** Makes an archive of a file that may be hostile. */
interface UploadEncoder {
    /**
     * @param model the file; its folder holds it and what belongs to it
     * @param archive to write, whole or not at all
     * @throws UploadFailure when the model is to blame
     * @throws InterruptedException when the server stops; no work goes on then
     */
    void encode(Path model, Path archive, ProgressListener progress)
            throws UploadFailure, IOException, InterruptedException;
}
