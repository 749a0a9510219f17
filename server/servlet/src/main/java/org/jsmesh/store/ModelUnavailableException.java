package org.jsmesh.store;

import java.io.IOException;

/** A model is in the store but cannot be served as an archive. */
public final class ModelUnavailableException extends IOException {
    private static final long serialVersionUID = 1L;
    /** What people can do about it. */
    private final String remedy;

    /** Whether nothing is wrong with the model, and asking again soon may help. */
    private final boolean passing;

    /**
     * Asking again soon does not help.
     *
     * @param reason what is wrong, for people
     * @param remedy what they can do about it
     * @param cause for the log
     */
    ModelUnavailableException(String reason, String remedy, Throwable cause) {
        this(reason, remedy, cause, false);
    }

    private ModelUnavailableException(String reason, String remedy, Throwable cause, boolean passing) {
        super(reason, cause);
        this.remedy = remedy;
        this.passing = passing;
    }

    /** Nothing is wrong with the model; asking again soon may help. */
    static ModelUnavailableException passing(String reason, String remedy, Throwable cause) {
        return new ModelUnavailableException(reason, remedy, cause, true);
    }

    /** {@return true when nothing is wrong with the model, and asking again soon may help} */
    public boolean isPassing() {
        return passing;
    }

    /** {@return what people can do about it, for a sentence behind the message} */
    public String remedy() {
        return remedy;
    }
}
