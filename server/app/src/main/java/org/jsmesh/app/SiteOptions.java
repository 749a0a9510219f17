package org.jsmesh.app;

import java.time.Duration;
import org.jsmesh.store.bucket.SiteSettings;
import picocli.CommandLine.Option;

/** How {@code jsm serve} reads a site that lies in a bucket. A mixin. */
final class SiteOptions {
    private static final long MEGABYTE = 1L << 20;

    @Option(
            names = "--redirect",
            description = {
                "Of a site in a bucket: send clients to the bucket for archives, so that their bytes do not pass this server.",
                "The bucket must allow pages of any origin to read (CORS). Default: the bytes are sent."
            })
    private boolean redirect;

    @Option(
            names = "--redirect-lifetime",
            paramLabel = "T",
            defaultValue = "900s",
            description = "How long the addresses of --redirect are good. Default: ${DEFAULT-VALUE}.")
    private Wait lifetime;

    @Option(
            names = "--site-memory",
            paramLabel = "N",
            description =
                    "MiB of archives of a site in a bucket that are kept in memory. Default: an eighth of the heap.")
    private Integer memory;

    /** @throws IllegalArgumentException that says what is wrong with an option */
    SiteSettings settings() {
        SiteSettings settings = SiteSettings.defaults();
        if (memory != null) settings = settings.withMemory(memory * MEGABYTE);
        return redirect ? settings.withRedirect(Duration.ofMillis(lifetime.millis())) : settings;
    }
}
