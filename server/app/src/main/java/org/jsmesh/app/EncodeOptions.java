package org.jsmesh.app;

import java.io.IOException;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.sandbox.SandboxEncoder;
import org.jsmesh.sandbox.SandboxLimits;
import org.jsmesh.store.StoreSettings;
import picocli.CommandLine.Option;

/** Limits for what {@code jsm serve} encodes of its folder and keeps. A mixin. */
final class EncodeOptions {
    private static final long MEGABYTE = 1L << 20;

    @Option(
            names = "--encoders",
            paramLabel = "N",
            description = "Models that are encoded at a time. Default: half the processors.")
    private Integer encoders;

    @Option(
            names = "--encode-memory",
            paramLabel = "N",
            description = "MiB of heap of the process that encodes a model. Default: as much as this process may take.")
    private Integer memory;

    @Option(
            names = "--encode-timeout",
            paramLabel = "T",
            defaultValue = "3600s",
            description = "How long encoding a model may take. Default: ${DEFAULT-VALUE}.")
    private Wait timeout;

    @Option(
            names = "--encode-max-faces",
            paramLabel = "N",
            defaultValue = "100000000",
            description = "Faces of a model. Default: ${DEFAULT-VALUE}.")
    private int faces;

    @Option(
            names = "--encode-queue",
            paramLabel = "N",
            defaultValue = "1000",
            description =
                    "Models that are encoded or wait for that; who asks for others is told to come again (503). Default: ${DEFAULT-VALUE}.")
    private int queued;

    @Option(
            names = "--encode-queue-per-address",
            paramLabel = "N",
            defaultValue = "100",
            description = "Of these, models that one address has asked for. Default: ${DEFAULT-VALUE}.")
    private int queuedPerAddress;

    @Option(
            names = "--cache-max-megabytes",
            paramLabel = "N",
            defaultValue = "20480",
            description =
                    "Size of all archives in the cache; those not used for longest go. Default: ${DEFAULT-VALUE} MiB.")
    private int cacheMegabytes;

    /** @throws IllegalArgumentException that says what is wrong with an option */
    StoreSettings apply(StoreSettings settings) {
        StoreSettings limited =
                settings.withWaiting(queued, queuedPerAddress).withCacheBytes(cacheMegabytes * MEGABYTE);
        return encoders == null ? limited : limited.withEncoders(encoders);
    }

    /** @throws IllegalArgumentException that says what is wrong with an option */
    ModelEncoder encoder() throws IOException {
        SandboxLimits limits =
                SandboxLimits.defaults().withEncodeMillis(timeout.millis()).withMostFaces(faces);
        return SandboxEncoder.of(memory == null ? limits : limits.withHeapMegabytes(memory));
    }
}
