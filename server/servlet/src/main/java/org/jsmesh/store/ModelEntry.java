package org.jsmesh.store;

import java.nio.file.Path;
import java.time.Instant;
import java.util.Objects;
import org.jsmesh.store.ids.IdText;
import org.jsmesh.store.ids.ModelIds;
import org.jsmesh.store.ids.ModelPath;

/**
 * A model of the store. Immutable. A folder may hold a hundred thousand of them, so it keeps no more than what its
 * other values are made from.
 */
public final class ModelEntry {
    private final String id;
    private final Path folder;
    private final String place;
    private final String format;
    private final long bytes;
    private final long modifiedSeconds;

    /**
     * @param folder of all models, one object for all of them
     * @param place of the file in the folder, with slashes
     * @param format one object for all models of one format
     * @param modifiedSeconds since 1970
     */
    ModelEntry(String id, Path folder, String place, String format, long bytes, long modifiedSeconds) {
        this.id = id;
        this.folder = folder;
        this.place = place;
        this.format = format;
        this.bytes = bytes;
        this.modifiedSeconds = modifiedSeconds;
    }

    /** {@return lower-case letters, digits and hyphens; unique in the store; see {@link ModelIds}} */
    public String id() {
        return id;
    }

    /** {@return the name of the file without its extension, as people wrote it} */
    public String name() {
        return ModelPath.stem(place.substring(place.lastIndexOf('/') + 1));
    }

    /** {@return the path of the model file or archive} */
    public Path path() {
        return folder.resolve(place);
    }

    /** {@return the extension of the file in lower case, {@code jsm} for an archive} */
    public String format() {
        return format;
    }

    /** {@return the size of the file when it was looked at last} */
    public long bytes() {
        return bytes;
    }

    /** {@return when the file was changed last, in whole seconds} */
    public Instant modified() {
        return Instant.ofEpochSecond(modifiedSeconds);
    }

    /** {@return true when the file is an archive already, and is not encoded} */
    public boolean isArchive() {
        return format.equals(FolderIndex.ARCHIVE);
    }

    /** {@return the id as a part of an address, with letters beyond ASCII percent-encoded as UTF-8} */
    public String segment() {
        return ModelIds.segment(id);
    }

    /** Where the file is in the folder, with slashes. */
    String place() {
        return place;
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

    @Override
    public boolean equals(Object other) {
        return other instanceof ModelEntry e
                && id.equals(e.id)
                && place.equals(e.place)
                && bytes == e.bytes
                && modifiedSeconds == e.modifiedSeconds
                && folder.equals(e.folder);
    }

    @Override
    public int hashCode() {
        return Objects.hash(id, place);
    }

    @Override
    public String toString() {
        return id + " (" + place + ", " + bytes + " bytes of " + modified() + ")";
    }
}
