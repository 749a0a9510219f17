package org.jsmesh.upload;

/** A model that was sent cannot be encoded, in words for the sender. */
public final class UploadFailure extends Exception {
    private static final long serialVersionUID = 1L;
    private final String remedy;

    public UploadFailure(String reason, String remedy) {
        super(reason);
        this.remedy = remedy;
    }

    public String remedy() {
        return remedy;
    }
}
