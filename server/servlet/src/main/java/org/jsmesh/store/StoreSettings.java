package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.Path;

/**
 * What a store serves and how.
 *
 * @param source a folder of archives and models, or one such file
 * @param cache folder in which encoded archives are kept
 * @param encoders models that are encoded at the same time
 */
public record StoreSettings(Path source, Path cache, int encoders) {
    /**
     * Checks the settings.
     *
     * @param source see {@link #source()}
     * @param cache see {@link #cache()}
     * @param encoders see {@link #encoders()}
     * @throws IllegalArgumentException when there is no encoder
     */
    public StoreSettings {
        if (encoders < 1) throw new IllegalArgumentException("encoders: " + encoders);
    }

    /**
     * Serves {@code source}, keeps archives in the user's cache folder and leaves half of the processors to other work.
     * Where that folder cannot be written, archives are kept in a new temporary one.
     *
     * @param source a folder of archives and models, or one such file
     * @return the settings
     * @throws IOException when no cache folder can be made
     */
    public static StoreSettings of(Path source) throws IOException {
        int encoders = Math.max(1, Runtime.getRuntime().availableProcessors() / 2);
        return new StoreSettings(source, ArchiveCache.defaultFolder(), encoders);
    }

    /**
     * Changes where encoded archives are kept.
     *
     * @param folder made when it is missing; it serves one machine
     * @return settings that differ in that alone
     */
    public StoreSettings withCache(Path folder) {
        return new StoreSettings(source, folder, encoders);
    }
}
