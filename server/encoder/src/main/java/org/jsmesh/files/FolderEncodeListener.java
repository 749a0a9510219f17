package org.jsmesh.files;

/** Hears how far the encoding of many files is, and may stop it. Several threads call it, but never two at a time. */
public interface FolderEncodeListener {
    /** Hears nothing and stops nothing. */
    FolderEncodeListener NONE = new FolderEncodeListener() {};

    /**
     * Hears how far a file is.
     *
     * @param job the file
     * @param stage what is being done with this file, a few words
     * @param fraction of this stage, 0 to 1
     */
    default void progress(EncodeJob job, String stage, double fraction) {}

    /**
     * A file is done or has failed.
     *
     * @param job the file
     * @param result what became of it
     */
    default void finished(EncodeJob job, EncodeResult result) {}

    /** True to give the work up. Archives that are already written stay; nothing is left of the others. */
    default boolean isCancelled() {
        return false;
    }
}
