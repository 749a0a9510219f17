package org.jsmesh.sandbox;

import java.io.IOException;

/** A model has no archive, for a reason that can be told to whoever asked for it. */
public final class EncodingFailure extends IOException {
    private static final long serialVersionUID = 1L;
    /** What people can do about it. */
    private final String remedy;

    /** Whether the model is not to blame. */
    private final boolean passing;

    private EncodingFailure(String reason, String remedy, boolean passing, Throwable cause) {
        super(reason, cause);
        this.remedy = remedy;
        this.passing = passing;
    }

    /**
     * The model is to blame: trying again does not help.
     *
     * @param reason one sentence
     * @param remedy another one
     * @return the failure
     */
    public static EncodingFailure ofModel(String reason, String remedy) {
        return new EncodingFailure(reason, remedy, false, null);
    }

    /**
     * The server is to blame, which has no room for the archive: trying again later may help.
     *
     * @param cause for the log, or null
     * @return the failure
     */
    public static EncodingFailure noRoom(Throwable cause) {
        return new EncodingFailure("the server has no room for the archive", "try again later", true, cause);
    }

    /** {@return what people can do about it} */
    public String remedy() {
        return remedy;
    }

    /** {@return true when the model is not to blame, and trying again later may help} */
    public boolean isPassing() {
        return passing;
    }
}
