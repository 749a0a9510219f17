package org.jsmesh.archive;

import java.util.List;

/**
 * An image in an archive. Each image is there once, however many names it has.
 *
 * @param paths under which materials know it, at least one
 * @param bytes of the image file
 * @param sha256 of those bytes as lower-case hexadecimal; empty in an {@link ArchiveOpening}, which does not have it
 *     yet
 */
public record ImageInfo(List<String> paths, int bytes, String sha256) {
    /**
     * Copies the list.
     *
     * @param paths see {@link #paths()}
     * @param bytes see {@link #bytes()}
     * @param sha256 see {@link #sha256()}
     */
    public ImageInfo {
        paths = List.copyOf(paths);
    }

    /**
     * Makes an image whose hash has not come.
     *
     * @param paths see {@link #paths()}
     * @param bytes see {@link #bytes()}
     */
    public ImageInfo(List<String> paths, int bytes) {
        this(paths, bytes, "");
    }
}
