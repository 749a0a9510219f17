package org.jsmesh.store;

import java.io.IOException;

/** A model is in the store but cannot be served as an archive. */
public final class ModelUnavailableException extends IOException {
    private static final long serialVersionUID = 1L;
    private final String remedy;

    /**
     * @param reason what is wrong, for people
     * @param remedy what they can do about it
     */
    public ModelUnavailableException(String reason, String remedy, Throwable cause) {
        super(reason, cause);
        this.remedy = remedy;
    }

    public String remedy() {
        return remedy;
    }
}
