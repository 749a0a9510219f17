package org.jsmesh.store;

import java.nio.file.Path;

/**
 * What a store serves and how.
 *
 * @param source a folder of archives and models, or one such file
 * @param cache folder in which encoded archives are kept; null for the user's cache folder
 * @param cacheBytes most bytes of archives in it; those that were not used for longest go first
 * @param encoders models that are encoded at the same time
 * @param mostWaiting models that are opened, encoded or wait for that at the same time
 * @param mostWaitingOfClient of these, models that one client has asked for
 * @param wishMillis after which a client's wish for an encoding is forgotten, unless somebody asks again
 * @param mostOpen archives that are open at the same time, besides those that are being sent
 */
public record StoreSettings(
        Path source,
        Path cache,
        long cacheBytes,
        int encoders,
        int mostWaiting,
        int mostWaitingOfClient,
        long wishMillis,
        int mostOpen) {
    private static final long CACHE_BYTES = 20L << 30;
    private static final int WAITING = 1000;
    private static final int WAITING_OF_CLIENT = 100;
    private static final long WISH_MILLIS = 30_000;
    private static final int OPEN = 512;

    /**
     * Checks the settings.
     *
     * @param source see {@link #source()}
     * @param cache see {@link #cache()}
     * @param cacheBytes see {@link #cacheBytes()}
     * @param encoders see {@link #encoders()}
     * @param mostWaiting see {@link #mostWaiting()}
     * @param mostWaitingOfClient see {@link #mostWaitingOfClient()}
     * @param wishMillis see {@link #wishMillis()}
     * @param mostOpen see {@link #mostOpen()}
     * @throws IllegalArgumentException when a number is below 1
     */
    public StoreSettings {
        if (cacheBytes < 1) throw new IllegalArgumentException("bytes of the cache: " + cacheBytes);
        if (encoders < 1) throw new IllegalArgumentException("encoders: " + encoders);
        if (mostWaiting < 1) throw new IllegalArgumentException("models that wait: " + mostWaiting);
        if (mostWaitingOfClient < 1)
            throw new IllegalArgumentException("models of a client that wait: " + mostWaitingOfClient);
        if (wishMillis < 1) throw new IllegalArgumentException("milliseconds of a wish: " + wishMillis);
        if (mostOpen < 1) throw new IllegalArgumentException("open archives: " + mostOpen);
    }

    /**
     * Serves {@code source}, keeps at most 20 GiB of archives in the user's cache folder and leaves half of the
     * processors to other work. Where that folder cannot be written, archives are kept in a new temporary one.
     *
     * @param source a folder of archives and models, or one such file
     * @return the settings
     */
    public static StoreSettings of(Path source) {
        int encoders = Math.max(1, Runtime.getRuntime().availableProcessors() / 2);
        return new StoreSettings(source, null, CACHE_BYTES, encoders, WAITING, WAITING_OF_CLIENT, WISH_MILLIS, OPEN);
    }

    /**
     * Changes where encoded archives are kept.
     *
     * @param folder made when it is missing
     * @return settings that differ in that alone
     */
    public StoreSettings withCache(Path folder) {
        return new StoreSettings(
                source, folder, cacheBytes, encoders, mostWaiting, mostWaitingOfClient, wishMillis, mostOpen);
    }

    /**
     * Changes how much the cache folder may hold.
     *
     * @param bytes of archives, at least 1
     * @return settings that differ in that alone
     */
    public StoreSettings withCacheBytes(long bytes) {
        return new StoreSettings(
                source, cache, bytes, encoders, mostWaiting, mostWaitingOfClient, wishMillis, mostOpen);
    }

    /**
     * Changes how many models are encoded at the same time.
     *
     * @param models at least 1
     * @return settings that differ in that alone
     */
    public StoreSettings withEncoders(int models) {
        return new StoreSettings(
                source, cache, cacheBytes, models, mostWaiting, mostWaitingOfClient, wishMillis, mostOpen);
    }

    /**
     * Changes how many models may wait to be opened or encoded.
     *
     * @param models in all, at least 1
     * @param ofClient that one client has asked for, at least 1
     * @return settings that differ in that alone
     */
    public StoreSettings withWaiting(int models, int ofClient) {
        return new StoreSettings(source, cache, cacheBytes, encoders, models, ofClient, wishMillis, mostOpen);
    }

    /**
     * Changes how long a client's wish for an encoding lasts.
     *
     * @param millis until it is forgotten, unless somebody asks again; at least 1
     * @return settings that differ in that alone
     */
    public StoreSettings withWishMillis(long millis) {
        return new StoreSettings(
                source, cache, cacheBytes, encoders, mostWaiting, mostWaitingOfClient, millis, mostOpen);
    }

    /**
     * Changes how many archives stay open.
     *
     * @param archives at least 1
     * @return settings that differ in that alone
     */
    public StoreSettings withOpen(int archives) {
        return new StoreSettings(
                source, cache, cacheBytes, encoders, mostWaiting, mostWaitingOfClient, wishMillis, archives);
    }
}
