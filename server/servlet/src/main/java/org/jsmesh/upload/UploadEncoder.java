package org.jsmesh.upload;

import java.io.IOException;
import java.nio.file.Path;
import org.jsmesh.mesh.ProgressListener;

/** Makes an archive of a file of which nothing good is to be expected. */
interface UploadEncoder {
    /**
     * @param model the file; its folder holds it and what belongs to it
     * @param archive to write, whole or not at all
     * @throws UploadFailure when the model is to blame
     * @throws InterruptedException when the server stops; nothing goes on behind its back then
     */
    void encode(Path model, Path archive, ProgressListener progress)
            throws UploadFailure, IOException, InterruptedException;
}
