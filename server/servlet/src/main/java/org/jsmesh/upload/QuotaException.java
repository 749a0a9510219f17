package org.jsmesh.upload;

/** The server keeps no more for a sender; the message says how much it keeps. */
public final class QuotaException extends Exception {
    private static final long serialVersionUID = 1L;

    static final String REMEDY =
            "delete models that nobody needs (DELETE /m/ID), or ask the server's owner for more room";

    QuotaException(String reason) {
        super(reason);
    }

    /** {@return what the sender can do about it} */
    public String remedy() {
        return REMEDY;
    }
}
