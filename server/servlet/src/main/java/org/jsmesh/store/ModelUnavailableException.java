package org.jsmesh.store;

import java.io.IOException;

/** A model is in the store but cannot be served as an archive. */
public final class ModelUnavailableException extends IOException {
    private static final long serialVersionUID = 1L;
    private static final long PASSING_SECONDS = 5;

    /** Who is to blame. */
    private enum Blame {
        MODEL,
        SERVER,
        GONE
    }

    /** What people can do about it. */
    private final String remedy;

    private final Blame blame;
    private final long retrySeconds;

    private ModelUnavailableException(String reason, String remedy, Blame blame, long retrySeconds, Throwable cause) {
        super(reason, cause);
        this.remedy = remedy;
        this.blame = blame;
        this.retrySeconds = retrySeconds;
    }

    /**
     * Asking again soon does not help.
     *
     * @param reason what is wrong, for people
     * @param remedy what they can do about it
     * @param cause for the log
     * @return what clients are told
     */
    public static ModelUnavailableException ofModel(String reason, String remedy, Throwable cause) {
        return new ModelUnavailableException(reason, remedy, Blame.MODEL, 0, cause);
    }

    /**
     * Nothing is wrong with the model; asking again soon may help.
     *
     * @param reason what is wrong, for people
     * @param remedy what they can do about it
     * @param cause for the log, or null
     * @return what clients are told
     */
    public static ModelUnavailableException passing(String reason, String remedy, Throwable cause) {
        return new ModelUnavailableException(reason, remedy, Blame.SERVER, PASSING_SECONDS, cause);
    }

    /**
     * There is no such model, or no longer.
     *
     * @param reason what is not there, for people
     * @return what clients are told
     */
    public static ModelUnavailableException absent(String reason) {
        return new ModelUnavailableException(
                reason, "see the catalogue, index.json, for what there is", Blame.GONE, 0, null);
    }

    /** There is no file of that model any more. */
    static ModelUnavailableException gone(String id, Throwable cause) {
        String reason = "the file of model '" + id + "' is not there any more";
        return new ModelUnavailableException(
                reason, "see the catalogue, index.json, for what there is", Blame.GONE, 0, cause);
    }

    /** The same, with the time after which it is tried again. */
    ModelUnavailableException retriedIn(long seconds) {
        if (blame != Blame.SERVER) return this;
        return new ModelUnavailableException(getMessage(), remedy, blame, Math.max(1, seconds), getCause());
    }

    /** {@return true when nothing is wrong with the model, and asking again may help} */
    public boolean isPassing() {
        return blame == Blame.SERVER;
    }

    /** {@return true when there is no such model any more} */
    public boolean isGone() {
        return blame == Blame.GONE;
    }

    /** {@return after how many seconds to ask again; only when the failure {@link #isPassing}} */
    public long retrySeconds() {
        return retrySeconds;
    }

    /** {@return what people can do about it, for a sentence behind the message} */
    public String remedy() {
        return remedy;
    }
}
