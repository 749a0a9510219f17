package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.store.ModelStore;
import org.jsmesh.upload.UploadSettings;
import org.jsmesh.upload.UploadTokens;
import picocli.CommandLine.Option;

/** Limits of {@code jsm serve} for clients that send models. A mixin. */
final class UploadOptions {
    private static final long MEGABYTE = 1 << 20;

    @Option(
            names = "--upload-token-file",
            paramLabel = "FILE",
            description = {
                "Take models by POST /m/ID from who has one of the tokens in this file, one a line.",
                "Behind a token may stand what the ids begin with that it is good for, quota=5G (bytes of archives",
                "that are kept for it) and models=100. The file is read again when it changes. Default: off."
            })
    private Path tokens;

    @Option(
            names = "--upload-max-megabytes",
            paramLabel = "N",
            defaultValue = "256",
            description = "Size of a model file, of a ZIP archive unpacked. Default: ${DEFAULT-VALUE} MiB.")
    private int megabytes;

    @Option(
            names = "--upload-max-faces",
            paramLabel = "N",
            description =
                    "Faces of a model. Default: as many as are sure to fit in --upload-memory if they share vertices, as surfaces do.")
    private Integer faces;

    @Option(
            names = "--upload-timeout",
            paramLabel = "T",
            defaultValue = "600s",
            description = "How long encoding a model may take. Default: ${DEFAULT-VALUE}.")
    private Wait timeout;

    @Option(
            names = "--upload-queue",
            paramLabel = "N",
            defaultValue = "8",
            description =
                    "Models that are received, wait or are encoded at a time; senders beyond are told to come again (429). Default: ${DEFAULT-VALUE}.")
    private int queued;

    @Option(
            names = "--upload-expiry",
            paramLabel = "T",
            defaultValue = "86400s",
            description =
                    "How long a model that comes in parts is kept without the next one. Default: ${DEFAULT-VALUE}.")
    private Wait expiry;

    @Option(
            names = "--upload-origins",
            paramLabel = "URL",
            split = ",",
            description = {
                "Pages of these origins may send and delete models, with a token; * for all.",
                "Several with commas between. Default: the server's own page alone."
            })
    private List<String> origins;

    @Option(
            names = "--upload-memory",
            paramLabel = "N",
            defaultValue = "2048",
            description = "MiB of heap of the process that encodes. Default: ${DEFAULT-VALUE}.")
    private int memory;

    /** Origins of other pages that may send. */
    List<String> origins() {
        return origins == null ? List.of() : origins;
    }

    /** Makes the store accept models if the options say so, and returns it. */
    ModelStore open(ModelStore store) throws IOException, CommandFailure {
        if (tokens == null) return store;
        try {
            store.acceptUploads(UploadSettings.of(UploadTokens.read(tokens))
                    .withMostBytes(megabytes * MEGABYTE)
                    .withMostFaces(faces == null ? UploadSettings.facesFor(memory) : faces)
                    .withEncodeMillis(timeout.millis())
                    .withQueued(queued)
                    .withUnfinishedMillis(expiry.millis())
                    .withHeapMegabytes(memory));
            return store;
        } catch (IOException | IllegalArgumentException e) {
            store.close();
            throw new CommandFailure("--upload-token-file", e);
        }
    }
}
