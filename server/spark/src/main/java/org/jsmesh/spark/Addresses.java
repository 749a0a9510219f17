package org.jsmesh.spark;

import java.net.URI;
import java.nio.file.Path;
import org.jsmesh.objects.ObjectStores;

/** Addresses as people write them. */
final class Addresses {
    private static final String FILE = "file:/";

    private Addresses() {}

    /**
     * Takes an address of a file, a folder or a store.
     *
     * @param given a path, an address that begins with {@code file:/}, or one of a store
     * @return of a file or folder of this machine the whole path, which executors are told; else what was given
     * @throws IllegalArgumentException when it can be neither
     */
    static String whole(String given) {
        return ObjectStores.isRemote(given)
                ? given
                : path(given).toAbsolutePath().normalize().toString();
    }

    private static Path path(String given) {
        if (!given.regionMatches(true, 0, FILE, 0, FILE.length())) return Path.of(given);
        try {
            return Path.of(URI.create(given));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(given + ": is no address of a file of this machine. Give its path", e);
        }
    }

    /** {@return the same of a folder or a part of a store, without slashes at its end} */
    static String folder(String given) {
        return whole(given).replaceFirst("(?<=[^/:])/+$", "");
    }

    /**
     * Tells whether a folder or a part of a store is another one or lies in it.
     *
     * @param inner as {@link #folder} gives it
     * @param outer likewise
     */
    static boolean isWithin(String inner, String outer) {
        return inner.equals(outer) || inner.startsWith(outer.endsWith("/") ? outer : outer + "/");
    }
}
