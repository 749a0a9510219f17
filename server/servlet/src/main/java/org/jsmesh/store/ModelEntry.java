package org.jsmesh.store;

import java.nio.file.Path;
import java.time.Instant;

/**
 * A model of the store.
 *
 * @param id lower-case letters, digits and hyphens; unique in the store; see {@link ModelIds}
 * @param name of the file without its extension, as people wrote it
 * @param path of the model file or archive
 * @param format extension of the file in lower case, {@code jsm} for an archive
 * @param bytes size of the file when it was found
 * @param modified when the file was changed last, in whole seconds
 */
public record ModelEntry(String id, String name, Path path, String format, long bytes, Instant modified) {
    /** {@return true when the file is an archive already, and is not encoded} */
    public boolean isArchive() {
        return format.equals(FolderScan.ARCHIVE);
    }

    /** {@return the id as a part of an address, with letters beyond ASCII percent-encoded as UTF-8} */
    public String segment() {
        return ModelIds.segment(id);
    }

    /**
     * Turns a name into the id of a model that is named so, or is sent under that name. Latin letters lose case and
     * accents; runs of all but letters and digits become one hyphen.
     *
     * @param name of a file without extension, or any text
     * @return lower-case letters and digits of any script, and hyphens; {@code model} when nothing is left
     */
    public static String idOf(String name) {
        String text = IdText.of(name).text();
        return text.isEmpty() ? "model" : text;
    }
}
