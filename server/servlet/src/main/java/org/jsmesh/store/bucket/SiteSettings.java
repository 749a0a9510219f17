package org.jsmesh.store.bucket;

import java.time.Duration;

/**
 * How a site in a store of objects is read.
 *
 * @param memoryBytes most bytes of archives that are kept in memory, at least a mebibyte
 * @param redirect how long addresses of the store are good to which clients are sent for archives; null to send the
 *     bytes
 */
public record SiteSettings(long memoryBytes, Duration redirect) {
    private static final long LEAST_BYTES = 1 << 20;
    private static final int SHARE_OF_HEAP = 8;

    /** Stores sign addresses for a week at most. */
    private static final Duration LONGEST = Duration.ofDays(7);

    /**
     * Checks the settings.
     *
     * @param memoryBytes see {@link #memoryBytes()}
     * @param redirect see {@link #redirect()}
     */
    public SiteSettings {
        if (memoryBytes < LEAST_BYTES)
            throw new IllegalArgumentException("memory for blocks of archives: " + memoryBytes + " bytes");
        if (redirect != null && (redirect.compareTo(Duration.ofSeconds(1)) < 0 || redirect.compareTo(LONGEST) > 0))
            throw new IllegalArgumentException("addresses of the store are good for 1 s to 7 days, not " + redirect);
    }

    /** {@return an eighth of the heap for archives, whose bytes are sent} */
    public static SiteSettings defaults() {
        return new SiteSettings(Math.max(LEAST_BYTES, Runtime.getRuntime().maxMemory() / SHARE_OF_HEAP), null);
    }

    /**
     * Changes how much is kept in memory.
     *
     * @param bytes of archives
     * @return settings that differ in that alone
     */
    public SiteSettings withMemory(long bytes) {
        return new SiteSettings(bytes, redirect);
    }

    /**
     * Sends clients to the store for archives: the bytes then do not pass through this server.
     *
     * @param lifetime how long an address is good, or null to send the bytes
     * @return settings that differ in that alone
     */
    public SiteSettings withRedirect(Duration lifetime) {
        return new SiteSettings(memoryBytes, lifetime);
    }
}
