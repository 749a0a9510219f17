package org.jsmesh.session;

import java.nio.file.Path;

/**
 * How a {@link StreamingSession} behaves.
 *
 * @param serverPlan true: the server's {@code patches} resource turns bandwidth and wait into batches (the paper's
 *     way); false: the client asks for the same batches by ranges, which works on any static host
 * @param http2 whether to use HTTP/2 where the server offers it, which it can only under TLS; without TLS it is always
 *     HTTP/1.1
 * @param attempts number of tries without receiving a byte before the session gives up
 * @param backoffMillis pause before the second attempt; doubled for each further one, up to 16 times
 * @param stallMillis a connection that delivers nothing for so long counts as broken
 * @param meshMillis least time between two snapshots of the mesh given to the listener while batches arrive; the base
 *     and the end of a round are always given
 * @param cache folder for archives with a known SHA-256, as far as they have come, for later sessions; null for none
 * @param cacheBytes that all archives in it may have together; those that were not used for longest go first
 * @param arrived is given every byte of the archive; null for none
 */
public record SessionOptions(
        boolean serverPlan,
        boolean http2,
        int attempts,
        int backoffMillis,
        int stallMillis,
        int meshMillis,
        Path cache,
        long cacheBytes,
        ArrivedBytes arrived) {
    /** 1 GiB. */
    public static final long DEFAULT_CACHE_BYTES = 1L << 30;

    /**
     * Checks the options.
     *
     * @param serverPlan see {@link #serverPlan()}
     * @param http2 see {@link #http2()}
     * @param attempts see {@link #attempts()}
     * @param backoffMillis see {@link #backoffMillis()}
     * @param stallMillis see {@link #stallMillis()}
     * @param meshMillis see {@link #meshMillis()}
     * @param cache see {@link #cache()}
     * @param cacheBytes see {@link #cacheBytes()}
     * @param arrived see {@link #arrived()}
     * @throws IllegalArgumentException when a number is out of its range
     */
    public SessionOptions {
        if (attempts < 1) throw new IllegalArgumentException("attempts: " + attempts);
        if (backoffMillis < 0) throw new IllegalArgumentException("backoff in milliseconds: " + backoffMillis);
        if (stallMillis < 1) throw new IllegalArgumentException("stall in milliseconds: " + stallMillis);
        if (meshMillis < 0) throw new IllegalArgumentException("time between meshes in milliseconds: " + meshMillis);
        if (cacheBytes < 0) throw new IllegalArgumentException("bytes of the cache: " + cacheBytes);
    }

    /**
     * {@return options of which the client plans; HTTP/2 where offered; six attempts, the first after 250 ms; broken
     * after 20 s of silence; a mesh at most every 150 ms; nothing kept on disk}
     */
    public static SessionOptions defaults() {
        return new SessionOptions(false, true, 6, 250, 20_000, 150, null, DEFAULT_CACHE_BYTES, null);
    }

    /**
     * Changes who plans.
     *
     * @param on true for the server
     * @return options that differ in that alone
     */
    public SessionOptions withServerPlan(boolean on) {
        return new SessionOptions(
                on, http2, attempts, backoffMillis, stallMillis, meshMillis, cache, cacheBytes, arrived);
    }

    /**
     * Changes whether HTTP/2 is spoken.
     *
     * @param on true where the server offers it
     * @return options that differ in that alone
     */
    public SessionOptions withHttp2(boolean on) {
        return new SessionOptions(
                serverPlan, on, attempts, backoffMillis, stallMillis, meshMillis, cache, cacheBytes, arrived);
    }

    /**
     * Changes how often a request is tried.
     *
     * @param count at least 1
     * @return options that differ in that alone
     */
    public SessionOptions withAttempts(int count) {
        return new SessionOptions(
                serverPlan, http2, count, backoffMillis, stallMillis, meshMillis, cache, cacheBytes, arrived);
    }

    /**
     * Changes the pause before the second attempt.
     *
     * @param millis of the pause, doubled for each further attempt
     * @return options that differ in that alone
     */
    public SessionOptions withBackoffMillis(int millis) {
        return new SessionOptions(
                serverPlan, http2, attempts, millis, stallMillis, meshMillis, cache, cacheBytes, arrived);
    }

    /**
     * Changes how long a connection may deliver nothing.
     *
     * @param millis after which it counts as broken
     * @return options that differ in that alone
     */
    public SessionOptions withStallMillis(int millis) {
        return new SessionOptions(
                serverPlan, http2, attempts, backoffMillis, millis, meshMillis, cache, cacheBytes, arrived);
    }

    /**
     * Changes how often the listener is given a mesh.
     *
     * @param millis between two meshes at least
     * @return options that differ in that alone
     */
    public SessionOptions withMeshMillis(int millis) {
        return new SessionOptions(
                serverPlan, http2, attempts, backoffMillis, stallMillis, millis, cache, cacheBytes, arrived);
    }

    /**
     * Changes where archives are kept.
     *
     * @param folder made when it is missing, or null
     * @return options that differ in that alone
     */
    public SessionOptions withCache(Path folder) {
        return new SessionOptions(
                serverPlan, http2, attempts, backoffMillis, stallMillis, meshMillis, folder, cacheBytes, arrived);
    }

    /**
     * Changes how much is kept.
     *
     * @param bytes that all archives in the cache may have together
     * @return options that differ in that alone
     */
    public SessionOptions withCacheBytes(long bytes) {
        return new SessionOptions(
                serverPlan, http2, attempts, backoffMillis, stallMillis, meshMillis, cache, bytes, arrived);
    }

    /**
     * Changes who is given the bytes of the archive.
     *
     * @param bytes that no other session is given, or null
     * @return options that differ in that alone
     */
    public SessionOptions withArrived(ArrivedBytes bytes) {
        return new SessionOptions(
                serverPlan, http2, attempts, backoffMillis, stallMillis, meshMillis, cache, cacheBytes, bytes);
    }
}
