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
    /** True when the file is an archive already. */
    public boolean isArchive() {
        return format.equals(FolderScan.ARCHIVE);
    }

    /** The id that a name or path of a file gives: lower-case letters, digits and hyphens. */
    public static String idOf(String name) {
        return FolderScan.slug(name);
    }
}
