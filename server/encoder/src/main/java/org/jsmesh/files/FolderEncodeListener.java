package org.jsmesh.files;

/**
 * Hears how far the encoding of many files is, and may stop it. Called from several threads, but never from two at a
 * time.
 */
public interface FolderEncodeListener {
    FolderEncodeListener NONE = new FolderEncodeListener() {};

    /**
     * @param stage what is being done with this file, a few words
     * @param fraction of this stage, 0 to 1
     */
    default void progress(EncodeJob job, String stage, double fraction) {}

    /** A file is done or has failed. */
    default void finished(EncodeJob job, EncodeResult result) {}

    /** True when the work is to be given up. Archives that are written stay; of the others nothing is left behind. */
    default boolean isCancelled() {
        return false;
    }
}
