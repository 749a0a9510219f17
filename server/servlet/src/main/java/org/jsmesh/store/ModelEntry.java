package org.jsmesh.store;

import java.nio.file.Path;

/**
 * A model of the store.
 *
 * @param id lower-case letters, digits and hyphens; unique in the store
 * @param name of the file without its extension, as people wrote it
 * @param path of the model file or archive
 * @param format extension of the file in lower case, {@code jsm} for an archive
 * @param bytes size of the file when it was found
 */
public record ModelEntry(String id, String name, Path path, String format, long bytes) {
    /** {@return true when the file is an archive already, and is not encoded} */
    public boolean isArchive() {
        return format.equals(FolderScan.ARCHIVE);
    }

    /**
     * Turns a name into an id. Letters lose case and accents; runs of all but ASCII letters and digits become one
     * hyphen.
     *
     * @param name or path of a file, or any text
     * @return lower-case letters, digits and hyphens; {@code model} when nothing is left
     */
    public static String idOf(String name) {
        return FolderScan.slug(name);
    }
}
