package org.jsmesh.files;

/**
 * Hears how far the encoding of many files is, and may stop it. Several threads call it. Two never report at the same
 * time, but {@link #isCancelled} may be asked at any time.
 */
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
     * Hears, before work on a file begins, that there may be too little memory for it.
     *
     * @param job the file
     * @param warning with reason and remedy
     */
    default void warned(EncodeJob job, String warning) {}

    /**
     * A file is done or has failed.
     *
     * @param job the file
     * @param result what became of it
     */
    default void finished(EncodeJob job, EncodeResult result) {}

    /**
     * Says whether to give the work up. Archives that are already written stay; nothing is left of the others. It is
     * asked often during each file.
     *
     * @return true to give up
     */
    default boolean isCancelled() {
        return false;
    }
}
